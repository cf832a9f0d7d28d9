//! Units in Structured Text are files of their own in a folder, and go back as they are.

use super::one_file::{back, difference, folder, told};
use expect_test::{Expect, expect};
use ladder_notation::write_one_file;
use ladder_notation_plcopen::Plcopen;

/// A block, a function and a program in Structured Text, a block whose loop leaves its variable otherwise in ladder text, and a program
/// in LD that uses the block.
const MIXER: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0201" xmlns:xhtml="http://www.w3.org/1999/xhtml">
<fileHeader companyName="Works" productName="Line" productVersion="1"/>
<types><dataTypes><dataType name="Phase"><baseType><enum><values><value name="IDLE"/><value name="FILL"/></values></enum></baseType></dataType></dataTypes><pous>
<pou name="Slope" pouType="functionBlock"><interface>
<inputVars><variable name="goal"><type><INT/></type><documentation><xhtml:p>where it goes</xhtml:p></documentation></variable></inputVars>
<outputVars><variable name="level"><type><INT/></type></variable></outputVars>
<localVars><variable name="phase"><type><derived name="Phase"/></type></variable></localVars>
<externalVars><variable name="fast"><type><BOOL/></type></variable></externalVars></interface>
<body><ST><xhtml:p><![CDATA[
(* nearer by one, or by ten *)
IF level < goal THEN
    phase := FILL;
    level := level + 1;
    IF fast THEN level := Nearer(level, goal); END_IF
END_IF;
]]></xhtml:p></ST></body><documentation><xhtml:p>A value that rises</xhtml:p></documentation></pou>
<pou name="Nearer" pouType="function"><interface><returnType><INT/></returnType>
<inputVars><variable name="from"><type><INT/></type></variable><variable name="goal"><type><INT/></type></variable></inputVars></interface>
<body><ST><xhtml:p><![CDATA[Nearer := MIN(from + 9, goal);]]></xhtml:p></ST></body></pou>
<pou name="Watch" pouType="program"><interface><localVars><variable name="seen"><type><INT/></type></variable></localVars>
<externalVars><variable name="fast"><type><BOOL/></type></variable></externalVars></interface>
<body><ST><xhtml:p><![CDATA[IF fast THEN seen := seen + 1; END_IF;]]></xhtml:p></ST></body></pou>
<pou name="Mix" pouType="program"><interface>
<localVars><variable name="r"><type><derived name="Slope"/></type></variable></localVars>
<outputVars><variable name="now"><type><INT/></type></variable></outputVars></interface><body><LD>
<leftPowerRail localId="1"/>
<inVariable localId="2"><expression>100</expression></inVariable>
<block localId="3" typeName="Slope" instanceName="r"><inputVariables>
<variable formalParameter="goal"><connectionPointIn><connection refLocalId="2"/></connectionPointIn></variable></inputVariables><inOutVariables/>
<outputVariables><variable formalParameter="level"><connectionPointOut/></variable></outputVariables></block>
<outVariable localId="4"><connectionPointIn><connection refLocalId="3" formalParameter="level"/></connectionPointIn><expression>now</expression></outVariable>
</LD></body></pou>
</pous></types>
<instances><configurations><configuration name="Line1">
<resource name="Main"><task name="fast" interval="T#20ms" priority="1"><pouInstance name="m" typeName="Mix"/></task>
<task name="slow" interval="T#100ms" priority="2"><pouInstance name="w" typeName="Watch"/></task></resource>
<globalVars><variable name="fast"><type><BOOL/></type></variable></globalVars>
</configuration></configurations></instances>
</project>
"#;

#[test]
fn what_is_structured_text_stays_that() {
    let files = folder(MIXER).expect("it can be read");
    let shown = files.iter().map(|(name, text)| format!("=== {name}\n{text}"));
    expect![[r#"
        === types.clad
        TYPE
            Phase : (IDLE, FILL);
        END_TYPE
        === globals.clad
        VAR_GLOBAL
            fast : BOOL;
        END_VAR
        === Slope.st
        (* A value that rises *)
        FUNCTION_BLOCK Slope
        VAR_INPUT
            goal : INT; // where it goes
        END_VAR
        VAR_OUTPUT
            level : INT;
        END_VAR
        VAR
            phase : Phase;
        END_VAR
        VAR_EXTERNAL
            fast : BOOL;
        END_VAR

        (* nearer by one, or by ten *)
        IF level < goal THEN
            phase := FILL;
            level := level + 1;
            IF fast THEN level := Nearer(level, goal); END_IF
        END_IF;
        END_FUNCTION_BLOCK
        === Nearer.st
        FUNCTION Nearer : INT
        VAR_INPUT
            from : INT;
            goal : INT;
        END_VAR

        Nearer := MIN(from + 9, goal);
        END_FUNCTION
        === Mix.clad
        VAR
            r : $Slope;
        END_VAR
        VAR_OUTPUT
            now : INT;
        END_VAR

        +--------------------------------------------------[$Slope]( r, goal := 100 )--+

        +-------------------------------------------------------[MOV]( now, r.level )--+
        === Watch.st
        PROGRAM Watch
        VAR
            seen : INT;
        END_VAR
        VAR_EXTERNAL
            fast : BOOL;
        END_VAR

        IF fast THEN seen := seen + 1; END_IF;
        END_PROGRAM
    "#]]
    .assert_eq(&shown.collect::<String>());
}

#[track_caller]
fn check(edits: &[(&str, &str, &str)], expected: Expect) {
    let mut files = folder(MIXER).expect("it can be read");
    for (name, from, to) in edits {
        let file = files.iter_mut().find(|(own, _)| own == name);
        let (_, text) = file.unwrap_or_else(|| panic!("there is no {name}"));
        assert!(text.contains(from), "{text}");
        *text = text.replacen(from, to, 1);
    }
    let written = back(MIXER, &files);
    expected.assert_eq(&difference(MIXER, &written));
    // What is written is read as what is there.
    let again = folder(&String::from_utf8(written.bytes.clone()).expect("it is UTF-8"));
    assert_eq!(
        again.expect("it can be read"),
        files,
        "{}",
        difference(MIXER, &written)
    );
}

#[test]
fn what_is_not_edited_is_as_it_was() {
    check(&[], expect![[""]]);
}

#[test]
fn statements_are_edited() {
    check(
        &[("Slope.st", "level + 1", "level + 2")],
        expect![[r#"
            -<pou name="Slope" pouType="functionBlock"><interface>
            -<inputVars><variable name="goal"><type><INT/></type><documentation><xhtml:p>where it goes</xhtml:p></documentation></variable></inputVars>
            -<outputVars><variable name="level"><type><INT/></type></variable></outputVars>
            -<localVars><variable name="phase"><type><derived name="Phase"/></type></variable></localVars>
            -<externalVars><variable name="fast"><type><BOOL/></type></variable></externalVars></interface>
            -<body><ST><xhtml:p><![CDATA[
            -(* nearer by one, or by ten *)
            -IF level < goal THEN
            +<pou name="Slope" pouType="functionBlock">
            +        <interface>
            +          <inputVars>
            +            <variable name="goal">
            +              <type>
            +                <INT/>
            +              </type>
            +              <documentation>
            +                <xhtml:p>where it goes</xhtml:p>
            +              </documentation>
            +            </variable>
            +          </inputVars>
            +          <outputVars>
            +            <variable name="level">
            +              <type>
            +                <INT/>
            +              </type>
            +            </variable>
            +          </outputVars>
            +          <localVars>
            +            <variable name="phase">
            +              <type>
            +                <derived name="Phase"/>
            +              </type>
            +            </variable>
            +          </localVars>
            +          <externalVars>
            +            <variable name="fast">
            +              <type>
            +                <BOOL/>
            +              </type>
            +            </variable>
            +          </externalVars>
            +        </interface>
            +        <body>
            +          <ST>
            +            <xhtml:p>(* nearer by one, or by ten *)
            +IF level &lt; goal THEN
            -    level := level + 1;
            +    level := level + 2;
            -]]></xhtml:p></ST></body><documentation><xhtml:p>A value that rises</xhtml:p></documentation></pou>
            +</xhtml:p>
            +          </ST>
            +        </body>
            +        <documentation>
            +          <xhtml:p>A value that rises</xhtml:p>
            +        </documentation>
            +      </pou>
        "#]],
    );
}

#[test]
fn a_function_is_edited() {
    check(
        &[("Nearer.st", "from + 9", "from + 8")],
        expect![[r#"
            -<pou name="Nearer" pouType="function"><interface><returnType><INT/></returnType>
            -<inputVars><variable name="from"><type><INT/></type></variable><variable name="goal"><type><INT/></type></variable></inputVars></interface>
            -<body><ST><xhtml:p><![CDATA[Nearer := MIN(from + 9, goal);]]></xhtml:p></ST></body></pou>
            +<pou name="Nearer" pouType="function">
            +        <interface>
            +          <returnType>
            +            <INT/>
            +          </returnType>
            +          <inputVars>
            +            <variable name="from">
            +              <type>
            +                <INT/>
            +              </type>
            +            </variable>
            +            <variable name="goal">
            +              <type>
            +                <INT/>
            +              </type>
            +            </variable>
            +          </inputVars>
            +        </interface>
            +        <body>
            +          <ST>
            +            <xhtml:p>Nearer := MIN(from + 8, goal);
            +</xhtml:p>
            +          </ST>
            +        </body>
            +      </pou>
        "#]],
    );
}

#[test]
fn a_program_is_edited() {
    check(
        &[("Watch.st", "seen : INT;", "seen : INT(0..100); // so often")],
        expect![[r#"
            -<pou name="Watch" pouType="program"><interface><localVars><variable name="seen"><type><INT/></type></variable></localVars>
            -<externalVars><variable name="fast"><type><BOOL/></type></variable></externalVars></interface>
            -<body><ST><xhtml:p><![CDATA[IF fast THEN seen := seen + 1; END_IF;]]></xhtml:p></ST></body></pou>
            +<pou name="Watch" pouType="program">
            +        <interface>
            +          <localVars>
            +            <variable name="seen">
            +              <type>
            +                <subrangeSigned>
            +                  <range lower="0" upper="100"/>
            +                  <baseType>
            +                    <INT/>
            +                  </baseType>
            +                </subrangeSigned>
            +              </type>
            +              <documentation>
            +                <xhtml:p>so often</xhtml:p>
            +              </documentation>
            +            </variable>
            +          </localVars>
            +          <externalVars>
            +            <variable name="fast">
            +              <type>
            +                <BOOL/>
            +              </type>
            +            </variable>
            +          </externalVars>
            +        </interface>
            +        <body>
            +          <ST>
            +            <xhtml:p>IF fast THEN seen := seen + 1; END_IF;
            +</xhtml:p>
            +          </ST>
            +        </body>
            +      </pou>
        "#]],
    );
}

#[test]
fn the_drawing_beside_it_is_edited() {
    check(
        &[("Mix.clad", "100", "200")],
        expect![[r#"
            -<pou name="Mix" pouType="program"><interface>
            -<localVars><variable name="r"><type><derived name="Slope"/></type></variable></localVars>
            -<outputVars><variable name="now"><type><INT/></type></variable></outputVars></interface><body><LD>
            -<leftPowerRail localId="1"/>
            -<inVariable localId="2"><expression>100</expression></inVariable>
            -<block localId="3" typeName="Slope" instanceName="r"><inputVariables>
            -<variable formalParameter="goal"><connectionPointIn><connection refLocalId="2"/></connectionPointIn></variable></inputVariables><inOutVariables/>
            -<outputVariables><variable formalParameter="level"><connectionPointOut/></variable></outputVariables></block>
            -<outVariable localId="4"><connectionPointIn><connection refLocalId="3" formalParameter="level"/></connectionPointIn><expression>now</expression></outVariable>
            -</LD></body></pou>
            +<pou name="Mix" pouType="program">
            +        <interface>
            +          <localVars>
            +            <variable name="r">
            +              <type>
            +                <derived name="Slope"/>
            +              </type>
            +            </variable>
            +          </localVars>
            +          <outputVars>
            +            <variable name="now">
            +              <type>
            +                <INT/>
            +              </type>
            +            </variable>
            +          </outputVars>
            +          <localVars>
            +            <variable name="unused">
            +              <type>
            +                <BOOL/>
            +              </type>
            +              <documentation>
            +                <xhtml:p>takes power that nothing else takes, so that its block runs in its turn</xhtml:p>
            +              </documentation>
            +            </variable>
            +          </localVars>
            +        </interface>
            +        <body>
            +          <LD>
            +            <leftPowerRail localId="1" height="40" width="10">
            +              <position x="10" y="20"/>
            +              <connectionPointOut formalParameter="">
            +                <relPosition x="10" y="20"/>
            +              </connectionPointOut>
            +            </leftPowerRail>
            +            <inVariable localId="2" height="30" width="50">
            +              <position x="60" y="55"/>
            +              <connectionPointOut>
            +                <relPosition x="50" y="15"/>
            +              </connectionPointOut>
            +              <expression>200</expression>
            +            </inVariable>
            +            <block localId="3" typeName="Slope" instanceName="r" height="70" width="100">
            +              <position x="130" y="10"/>
            +              <inputVariables>
            +                <variable formalParameter="EN">
            +                  <connectionPointIn>
            +                    <relPosition x="0" y="30"/>
            +                    <connection refLocalId="1">
            +                      <position x="130" y="40"/>
            +                      <position x="20" y="40"/>
            +                    </connection>
            +                  </connectionPointIn>
            +                </variable>
            +                <variable formalParameter="goal">
            +                  <connectionPointIn>
            +                    <relPosition x="0" y="60"/>
            +                    <connection refLocalId="2">
            +                      <position x="130" y="70"/>
            +                      <position x="110" y="70"/>
            +                    </connection>
            +                  </connectionPointIn>
            +                </variable>
            +              </inputVariables>
            +              <inOutVariables/>
            +              <outputVariables>
            +                <variable formalParameter="ENO">
            +                  <connectionPointOut>
            +                    <relPosition x="100" y="30"/>
            +                  </connectionPointOut>
            +                </variable>
            +                <variable formalParameter="level">
            +                  <connectionPointOut>
            +                    <relPosition x="100" y="60"/>
            +                  </connectionPointOut>
            +                </variable>
            +              </outputVariables>
            +            </block>
            +            <coil localId="4" height="20" width="30">
            +              <position x="270" y="30"/>
            +              <connectionPointIn>
            +                <relPosition x="0" y="10"/>
            +                <connection refLocalId="3" formalParameter="ENO">
            +                  <position x="270" y="40"/>
            +                  <position x="230" y="40"/>
            +                </connection>
            +              </connectionPointIn>
            +              <connectionPointOut>
            +                <relPosition x="30" y="10"/>
            +              </connectionPointOut>
            +              <variable>unused</variable>
            +            </coil>
            +            <leftPowerRail localId="5" height="40" width="10">
            +              <position x="10" y="105"/>
            +              <connectionPointOut formalParameter="">
            +                <relPosition x="10" y="20"/>
            +              </connectionPointOut>
            +            </leftPowerRail>
            +            <inVariable localId="6" height="30" width="80">
            +              <position x="60" y="140"/>
            +              <connectionPointOut>
            +                <relPosition x="80" y="15"/>
            +              </connectionPointOut>
            +              <expression>r.level</expression>
            +            </inVariable>
            +            <block localId="7" typeName="MOVE" height="70" width="60">
            +              <position x="160" y="95"/>
            +              <inputVariables>
            +                <variable formalParameter="EN">
            +                  <connectionPointIn>
            +                    <relPosition x="0" y="30"/>
            +                    <connection refLocalId="5">
            +                      <position x="160" y="125"/>
            +                      <position x="20" y="125"/>
            +                    </connection>
            +                  </connectionPointIn>
            +                </variable>
            +                <variable formalParameter="IN">
            +                  <connectionPointIn>
            +                    <relPosition x="0" y="60"/>
            +                    <connection refLocalId="6">
            +                      <position x="160" y="155"/>
            +                      <position x="140" y="155"/>
            +                    </connection>
            +                  </connectionPointIn>
            +                </variable>
            +              </inputVariables>
            +              <inOutVariables/>
            +              <outputVariables>
            +                <variable formalParameter="ENO">
            +                  <connectionPointOut>
            +                    <relPosition x="60" y="30"/>
            +                  </connectionPointOut>
            +                </variable>
            +                <variable formalParameter="OUT">
            +                  <connectionPointOut>
            +                    <relPosition x="60" y="60"/>
            +                  </connectionPointOut>
            +                </variable>
            +              </outputVariables>
            +            </block>
            +            <outVariable localId="8" height="30" width="50">
            +              <position x="260" y="140"/>
            +              <connectionPointIn>
            +                <relPosition x="0" y="15"/>
            +                <connection refLocalId="7" formalParameter="OUT">
            +                  <position x="260" y="155"/>
            +                  <position x="220" y="155"/>
            +                </connection>
            +              </connectionPointIn>
            +              <expression>now</expression>
            +            </outVariable>
            +            <rightPowerRail localId="9" height="40" width="10">
            +              <position x="340" y="20"/>
            +              <connectionPointIn>
            +                <relPosition x="0" y="20"/>
            +                <connection refLocalId="4">
            +                  <position x="340" y="40"/>
            +                  <position x="300" y="40"/>
            +                </connection>
            +              </connectionPointIn>
            +            </rightPowerRail>
            +          </LD>
            +        </body>
            +      </pou>
        "#]],
    );
}

#[test]
fn a_folder_that_comes_from_no_file() {
    let files = folder(MIXER).expect("it can be read");
    let written =
        write_one_file(&Plcopen, &files, &[], "plant", None).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(told(&written), "");
    let again = folder(&String::from_utf8(written.bytes).expect("it is UTF-8"));
    assert_eq!(again.expect("it can be read"), files);
}

#[test]
fn a_text_that_does_not_parse_is_not_written() {
    let mut files = folder(MIXER).expect("it can be read");
    let file = files
        .iter_mut()
        .find(|(name, _)| name == "Watch.st")
        .expect("it is there");
    file.1 = file.1.replace("THEN", "");
    let error = write_one_file(&Plcopen, &files, &[], "plant", None).expect_err("it has an error");
    expect!["Watch.st:9:10: `THEN` is expected here, not `seen`"].assert_eq(&error.to_string());
}
