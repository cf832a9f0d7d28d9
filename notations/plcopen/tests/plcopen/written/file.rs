//! A file as other editors have it.

use super::xml;
use expect_test::expect;

#[test]
fn a_whole_file() {
    let (xml, _) = xml(r"# A lamp #
VAR_INPUT  on : BOOL;  END_VAR
VAR_OUTPUT lamp AT %QX0.0 : BOOL;  END_VAR
VAR  t : TON;  END_VAR

# It waits #
+--[ ]( on )--[TON]( t, 2s )--( )( lamp )--+
");
    expect![[r#"
        <?xml version="1.0" encoding="utf-8"?>
        <project xmlns="http://www.plcopen.org/xml/tc6_0201" xmlns:xhtml="http://www.w3.org/1999/xhtml">
          <fileHeader companyName="" productName="Unnamed" productVersion="0.1.0" creationDateTime="2000-01-01T00:00:00"/>
          <contentHeader name="plant">
            <coordinateInfo>
              <fbd>
                <scaling x="10" y="10"/>
              </fbd>
              <ld>
                <scaling x="10" y="10"/>
              </ld>
              <sfc>
                <scaling x="10" y="10"/>
              </sfc>
            </coordinateInfo>
          </contentHeader>
          <types>
            <dataTypes/>
            <pous>
              <pou name="plant" pouType="program">
                <interface>
                  <inputVars>
                    <variable name="on_1">
                      <type>
                        <BOOL/>
                      </type>
                    </variable>
                  </inputVars>
                  <localVars>
                    <variable name="lamp" address="%QX0.0">
                      <type>
                        <BOOL/>
                      </type>
                    </variable>
                  </localVars>
                  <localVars>
                    <variable name="t">
                      <type>
                        <derived name="TON"/>
                      </type>
                    </variable>
                  </localVars>
                </interface>
                <body>
                  <LD>
                    <comment localId="1" height="40" width="120">
                      <position x="20" y="20"/>
                      <content>
                        <xhtml:p>It waits</xhtml:p>
                      </content>
                    </comment>
                    <leftPowerRail localId="2" height="40" width="10">
                      <position x="10" y="80"/>
                      <connectionPointOut formalParameter="">
                        <relPosition x="10" y="20"/>
                      </connectionPointOut>
                    </leftPowerRail>
                    <contact localId="3" height="20" width="30">
                      <position x="60" y="90"/>
                      <connectionPointIn>
                        <relPosition x="0" y="10"/>
                        <connection refLocalId="2">
                          <position x="60" y="100"/>
                          <position x="20" y="100"/>
                        </connection>
                      </connectionPointIn>
                      <connectionPointOut>
                        <relPosition x="30" y="10"/>
                      </connectionPointOut>
                      <variable>on_1</variable>
                    </contact>
                    <inVariable localId="4" height="30" width="60">
                      <position x="130" y="115"/>
                      <connectionPointOut>
                        <relPosition x="60" y="15"/>
                      </connectionPointOut>
                      <expression>T#2s</expression>
                    </inVariable>
                    <block localId="5" typeName="TON" instanceName="t" height="70" width="60">
                      <position x="210" y="70"/>
                      <inputVariables>
                        <variable formalParameter="IN">
                          <connectionPointIn>
                            <relPosition x="0" y="30"/>
                            <connection refLocalId="3">
                              <position x="210" y="100"/>
                              <position x="90" y="100"/>
                            </connection>
                          </connectionPointIn>
                        </variable>
                        <variable formalParameter="PT">
                          <connectionPointIn>
                            <relPosition x="0" y="60"/>
                            <connection refLocalId="4">
                              <position x="210" y="130"/>
                              <position x="190" y="130"/>
                            </connection>
                          </connectionPointIn>
                        </variable>
                      </inputVariables>
                      <inOutVariables/>
                      <outputVariables>
                        <variable formalParameter="Q">
                          <connectionPointOut>
                            <relPosition x="60" y="30"/>
                          </connectionPointOut>
                        </variable>
                        <variable formalParameter="ET">
                          <connectionPointOut>
                            <relPosition x="60" y="60"/>
                          </connectionPointOut>
                        </variable>
                      </outputVariables>
                    </block>
                    <coil localId="6" height="20" width="30">
                      <position x="310" y="90"/>
                      <connectionPointIn>
                        <relPosition x="0" y="10"/>
                        <connection refLocalId="5" formalParameter="Q">
                          <position x="310" y="100"/>
                          <position x="270" y="100"/>
                        </connection>
                      </connectionPointIn>
                      <connectionPointOut>
                        <relPosition x="30" y="10"/>
                      </connectionPointOut>
                      <variable>lamp</variable>
                    </coil>
                    <rightPowerRail localId="7" height="40" width="10">
                      <position x="380" y="80"/>
                      <connectionPointIn>
                        <relPosition x="0" y="20"/>
                        <connection refLocalId="6">
                          <position x="380" y="100"/>
                          <position x="340" y="100"/>
                        </connection>
                      </connectionPointIn>
                    </rightPowerRail>
                  </LD>
                </body>
                <documentation>
                  <xhtml:p>A lamp</xhtml:p>
                </documentation>
              </pou>
            </pous>
          </types>
          <instances>
            <configurations>
              <configuration name="config">
                <resource name="resource1">
                  <task name="scan" priority="0" interval="T#10ms">
                    <pouInstance name="instance0" typeName="plant"/>
                  </task>
                </resource>
              </configuration>
            </configurations>
          </instances>
        </project>
    "#]].assert_eq(&xml);
}
