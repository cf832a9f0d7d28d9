//! Projects in the form of IEC 61131-10.

use crate::harness::check;
use expect_test::expect;

pub(crate) const PROJECT: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Project xmlns="www.iec.ch/public/TC65SC65BWG7TF10" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" schemaVersion="1.0">
  <FileHeader companyName="" productName="Editor" productVersion="1"/>
  <ContentHeader name="Plant" creationDateTime="2026-01-02T03:04:05"/>
  <Types><GlobalNamespace>
    <DataTypeDecl name="Phase"><UserDefinedTypeSpec xsi:type="EnumTypeSpec"><Enumerator name="IDLE"/><Enumerator name="RUN"/></UserDefinedTypeSpec></DataTypeDecl>
    <DataTypeDecl name="Pump"><UserDefinedTypeSpec xsi:type="StructTypeSpec">
      <Member name="speed"><Type><TypeName>REAL</TypeName></Type><InitialValue><SimpleValue value="1.5"/></InitialValue></Member>
      <Member name="ran"><Type><InstantlyDefinedType xsi:type="ArrayTypeSpec"><BaseType><TypeName>TIME</TypeName></BaseType><DimensionSpec dimensionNumber="1"><IndexRange lower="1" upper="3"/></DimensionSpec></InstantlyDefinedType></Type></Member>
    </UserDefinedTypeSpec></DataTypeDecl>
    <FunctionBlock name="Motor">
      <Parameters>
        <InputVars><Variable name="go"><Type><TypeName>BOOL</TypeName></Type></Variable></InputVars>
        <OutputVars><Variable name="on"><Type><TypeName>BOOL</TypeName></Type></Variable></OutputVars>
      </Parameters>
      <Vars><Variable name="t"><Type><TypeName>TON</TypeName></Type></Variable></Vars>
      <MainBody><BodyContent xsi:type="LD"><Rung evaluationOrder="1">
        <LdObject xsi:type="LeftPowerRail"><ConnectionPointOut connectionPointOutId="1"/></LdObject>
        <LdObject xsi:type="Contact" operand="go" edge="rising"><ConnectionPointIn><Connection refConnectionPointOutId="1"/></ConnectionPointIn><ConnectionPointOut connectionPointOutId="2"/></LdObject>
        <LdObject xsi:type="Coil" operand="on" latch="set"><ConnectionPointIn><Connection refConnectionPointOutId="2"/></ConnectionPointIn><ConnectionPointOut connectionPointOutId="3"/></LdObject>
        <LdObject xsi:type="RightPowerRail"><ConnectionPointIn><Connection refConnectionPointOutId="3"/></ConnectionPointIn></LdObject>
      </Rung></BodyContent></MainBody>
    </FunctionBlock>
    <Program name="Main">
      <Vars retain="true"><Variable name="n"><Type><TypeName>INT</TypeName></Type><InitialValue><SimpleValue value="3"/></InitialValue></Variable></Vars>
      <Vars>
        <Variable name="a"><Type><TypeName>BOOL</TypeName></Type><Address address="%IX0.0"/></Variable>
        <Variable name="m"><Type><TypeName>Motor</TypeName></Type></Variable>
        <Variable name="p"><Type><TypeName>Pump</TypeName></Type></Variable>
        <Variable name="wait"><Type><TypeName>TON</TypeName></Type></Variable>
      </Vars>
      <MainBody><BodyContent xsi:type="LD">
        <Rung evaluationOrder="1">
          <CommonObject xsi:type="Comment"><Content xsi:type="SimpleText">It waits</Content></CommonObject>
          <LdObject xsi:type="LeftPowerRail"><RelPosition x="10" y="10"/><ConnectionPointOut connectionPointOutId="1"/><ConnectionPointOut connectionPointOutId="2"/></LdObject>
          <LdObject xsi:type="Contact" operand="a"><ConnectionPointIn><Connection refConnectionPointOutId="1"/></ConnectionPointIn><ConnectionPointOut connectionPointOutId="3"/></LdObject>
          <LdObject xsi:type="Contact" operand="wait.Q" negated="true"><ConnectionPointIn><Connection refConnectionPointOutId="2"/></ConnectionPointIn><ConnectionPointOut connectionPointOutId="4"/></LdObject>
          <FbdObject xsi:type="DataSource" identifier="T#2s"><ConnectionPointOut connectionPointOutId="5"/></FbdObject>
          <FbdObject xsi:type="Block" typeName="TON" instanceName="wait">
            <InOutVariables/>
            <InputVariables>
              <InputVariable parameterName="IN"><ConnectionPointIn><Connection refConnectionPointOutId="3"/><Connection refConnectionPointOutId="4"/></ConnectionPointIn></InputVariable>
              <InputVariable parameterName="PT"><ConnectionPointIn><Connection refConnectionPointOutId="5"/></ConnectionPointIn></InputVariable>
            </InputVariables>
            <OutputVariables><OutputVariable parameterName="Q"><ConnectionPointOut connectionPointOutId="6"/></OutputVariable><OutputVariable parameterName="ET"><ConnectionPointOut connectionPointOutId="7"/></OutputVariable></OutputVariables>
          </FbdObject>
          <LdObject xsi:type="Coil" operand="lamp" negated="true"><ConnectionPointIn><Connection refConnectionPointOutId="6"/></ConnectionPointIn><ConnectionPointOut connectionPointOutId="8"/></LdObject>
        </Rung>
        <Rung evaluationOrder="2" label="end">
          <LdObject xsi:type="LeftPowerRail"><ConnectionPointOut connectionPointOutId="1"/></LdObject>
          <FbdObject xsi:type="Block" typeName="Motor" instanceName="m">
            <InputVariables><InputVariable parameterName="go"><ConnectionPointIn><Connection refConnectionPointOutId="1"/></ConnectionPointIn></InputVariable></InputVariables>
            <OutputVariables><OutputVariable parameterName="on"><ConnectionPointOut connectionPointOutId="2"/></OutputVariable></OutputVariables>
          </FbdObject>
          <LdObject xsi:type="Contact" operand="b"><ConnectionPointIn><Connection refConnectionPointOutId="2"/></ConnectionPointIn><ConnectionPointOut connectionPointOutId="3"/></LdObject>
          <FbdObject xsi:type="Jump" targetLabel="end"><ConnectionPointIn><Connection refConnectionPointOutId="3"/></ConnectionPointIn></FbdObject>
          <LdObject xsi:type="Coil" operand="b"><ConnectionPointIn><Connection refConnectionPointOutId="9"/></ConnectionPointIn></LdObject>
          <LdObject xsi:type="Wormhole"/>
        </Rung>
      </BodyContent></MainBody>
    </Program>
  </GlobalNamespace></Types>
  <Instances><Configuration name="c"><Resource name="r" resourceTypeName="x">
    <GlobalVars><Variable name="lamp"><Type><TypeName>BOOL</TypeName></Type></Variable><Variable name="b"><Type><TypeName>BOOL</TypeName></Type></Variable></GlobalVars>
    <Task name="t" interval="T#20ms" priority="1"/>
    <ProgramInstance name="i" typeName="Main" associatedTaskName="t"/>
  </Resource></Configuration></Instances>
</Project>
"#;

#[test]
fn a_whole_project() {
    check(
        PROJECT,
        expect![[r#"
        # Plant, from Editor #
        # ladder: cycle 20ms #

        TYPE
            Phase : (IDLE, RUN);
            Pump  : STRUCT
                speed : REAL := 1.5;
                ran   : ARRAY[1..3] OF TIME;
            END_STRUCT;
        END_TYPE

        VAR_GLOBAL
            lamp : BOOL;
            b    : BOOL;
        END_VAR

        FUNCTION_BLOCK [$Motor]
        VAR_INPUT
            go : BOOL := FALSE;
        END_VAR
        VAR_OUTPUT
            on : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        +--[P]( go )--------------------------------------------------------(S)( on )--+
        END_FUNCTION_BLOCK

        VAR RETAIN
            n : INT := 3;
        END_VAR
        VAR
            a    AT %IX0.0 : BOOL;
            m              : $Motor;
            p              : Pump;
            wait           : TON;
            m_go           : BOOL;  # what comes to a pin #
        END_VAR

        # It waits #
        +--\--[ ]( a )-------\-----------------------[TON]( wait, T#2s )--(/)( lamp )--+
        |  /--[/]( wait.Q )--/                                                         |

        +--<LBL>( end )----------------------------------------------------------------+

        +-----------------------------------------------------------------( )( m_go )--+

        +---------------------------------------------------[$Motor]( m, go := m_go )--+

        +--[ ]( m.on )--[ ]( b )-----------------------------------------<JMP>( end )--+

        # Wormhole, which has no counterpart here #
        +--[ ]( SYS.OFF )----------------------------------------------------( )( b )--+
        approximated coil b: nothing is wired to it: no power comes there
        refused connection to 9: no element of the rung has this output
        refused Wormhole: it has no counterpart
    "#]],
    );
}
