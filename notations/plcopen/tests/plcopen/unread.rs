//! What is not read: texts between drawings, texts that may end the unit, blocks that nothing declares, tasks at other times.

use crate::harness::{check, program, project, short, unit};
use expect_test::expect;

fn drawn(tag: &str) -> String {
    let rung = short(&format!("leftPowerRail 1\ncoil 2 from=1 {tag}"));
    format!("<body><LD>{rung}</LD></body>")
}

#[test]
fn worksheets_stay_in_their_order() {
    let variables = "<localVars><variable name=\"a\"><type><BOOL/></type></variable><variable name=\"b\"><type><BOOL/></type></variable></localVars>";
    let text = "<body WorksheetName=\"middle\"><ST>a := b;</ST></body>";
    let main = format!(
        "<pou name=\"Main\" pouType=\"program\"><interface>{variables}</interface>{}{text}{}</pou>",
        drawn("a"),
        drawn("b")
    );
    check(
        &project("", &main, ""),
        expect![[r#"
            # worksheet middle of Main is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$worksheet_middle_of_Main]
            # ladder: unread #
            # a := b; #
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
                b : BOOL;
            END_VAR

            +--------------------------------------------------------------------( )( a )--+

            +-------------------------------------------------[$worksheet_middle_of_Main]--+

            +--------------------------------------------------------------------( )( b )--+
            approximated worksheet middle: a text is not read: a scan runs past it, and what it may write is not known
        "#]],
    );
}

#[test]
fn a_text_that_may_end_the_unit_takes_it_along() {
    let body = |code: &str| format!("leftPowerRail 1\ncontact 2 from=1 a\nBOX 3 {code}\ncoil 4 from=3 b");
    let of = |code: &str| {
        let text = program("a : BOOL\nb : BOOL", &body("x"));
        let start = text.find("\n<BOX").expect("the box is there");
        let end = text.find("</BOX>").expect("the box ends") + "</BOX>".len();
        let block = format!(
            "<block localId=\"3\" typeName=\"EXECUTE\"><inputVariables><variable formalParameter=\"EN\"><connectionPointIn><connection refLocalId=\"2\"/></connectionPointIn></variable></inputVariables><inOutVariables/><outputVariables><variable formalParameter=\"ENO\"><connectionPointOut/></variable></outputVariables><addData><data><STCode>{code}</STCode></data></addData></block>"
        );
        project("", &format!("{}{block}{}", &text[..start], &text[end..]), "")
    };
    check(
        &of("b := FALSE;"),
        expect![[r#"
            VAR
                a     : BOOL;
                b     : BOOL;
                power : BOOL;  # the power after a block #
            END_VAR

            +--[ ]( a )--( )( power )--[NOT]-------------------------------<JMP>( past1 )--+

            +-----------------------------------------------------------[MOV]( b, FALSE )--+

            +--<LBL>( past1 )--[ ]( power )--------------------------------------( )( b )--+
        "#]],
    );
    check(
        &of("IF a THEN RETURN; END_IF;"),
        expect![[r#"
            # Main (LD) is not read (a RETURN, EXIT or GOTO may leave the text of a box): a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$Main_LD]
            # ladder: unread #
            # \h EXECUTE is not read: a scan runs past it, and what it may write is not known. \h #
            # FUNCTION_BLOCK [$EXECUTE] #
            # \h ladder: unread \h #
            # \h IF a THEN RETURN; END_IF; \h #
            # END_FUNCTION_BLOCK #
            #  #
            # +--[ ]( a )----------------------------------------------[$EXECUTE]--( )( b )--+ #
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
                b : BOOL;
            END_VAR

            +------------------------------------------------------------------[$Main_LD]--+
            approximated body of Main: LD is not read: a scan runs past it, and what it may write is not known
        "#]],
    );
}

#[test]
fn blocks_that_nothing_declares() {
    let main = program(
        "a : BOOL\nn : INT\nt : TIME\nfilter : LibFilter\ndelay : TON\nq : BOOL",
        "leftPowerRail 1
         contact 2 from=1 a
         inVariable 3 n
         block 4 LibFilter filter EN=2 IN=3 / ENO OUT LATE HIGH
         outVariable 5 from=4.OUT n
         block 6 TON delay IN=4.HIGH PT=4.LATE / Q ET
         coil 7 from=6 q",
    );
    check(
        &project("", &main, ""),
        expect![[r#"
        # LibFilter is not read: a scan runs past it, and what it may write is not known. #
        FUNCTION_BLOCK [$LibFilter]
        VAR_INPUT
            operands : STRING[254] := '';
        END_VAR
        # ladder: unread #
        END_FUNCTION_BLOCK

        VAR
            a           : BOOL;
            n           : INT;
            t           : TIME;
            delay       : TON;
            q           : BOOL;
            libfilter   : TIME;  # the result of LibFilter #
            libfilter_2 : BOOL;  # the result of LibFilter #
        END_VAR

        +--[ ]( a )---[$LibFilter]( 'filter, IN := n, OUT => n, LATE => libfilter, HIGH => libfilter_2' )--+

        +--[ ]( libfilter_2 )---------------------[TON]( delay, libfilter )--( )( q )--+
        approximated variable filter: it holds the state of a block that is not read, and is left out with that
        approximated LibFilter filter: neither the project nor ladder text has a block `LibFilter`: a scan runs past it, and what it may write is not known
    "#]],
    );
}

#[test]
fn tasks_at_other_times() {
    let of = |name: &str, body: &str| unit("program", name, "a : BOOL\nb : BOOL", body);
    let fast = of(
        "Fast",
        &format!(
            "<LD>{}</LD>",
            short("leftPowerRail 1\ncontact 2 from=1 a\ncoil 3 from=2 shared")
        ),
    );
    let once = of(
        "Once",
        &format!("<LD>{}</LD>", short("leftPowerRail 1\ncoil 2 from=1 shared")),
    );
    let text = of("Text", "<ST>shared := FALSE;</ST>");
    let instances = r#"<configuration name="c"><resource name="r"><task name="fast" interval="T#20ms" priority="1"><pouInstance name="f" typeName="Fast"/></task>
<task name="event" single="shared" priority="2"><pouInstance name="o" typeName="Once"/><pouInstance name="t" typeName="Text"/></task>
<globalVars><variable name="shared"><type><BOOL/></type></variable><variable name="other"><type><BOOL/></type></variable></globalVars></resource></configuration>"#;
    check(
        &project("", &(fast + &once + &text), instances),
        expect![[r#"
            # ladder: cycle 20ms #

            VAR_GLOBAL
                shared : BOOL;
                other  : BOOL;
            END_VAR

            # Once in task event: it runs when shared rises there, between any two networks of the other tasks. #
            FUNCTION_BLOCK [$Once_in_task_event]
            # ladder: unread, at any time, writes Once_a, Once_b, shared #
            # when shared rises #
            END_FUNCTION_BLOCK

            # Text in task event: it runs when shared rises there, between any two networks of the other tasks. #
            FUNCTION_BLOCK [$Text_in_task_event]
            # ladder: unread, at any time #
            # when shared rises #
            END_FUNCTION_BLOCK

            # of Fast #
            VAR
                a : BOOL;
                b : BOOL;
            END_VAR

            # of Once #
            VAR
                Once_a : BOOL;  # a in the project #
                Once_b : BOOL;  # b in the project #
            END_VAR

            # of Text #
            VAR
                Text_a : BOOL;  # a in the project #
                Text_b : BOOL;  # b in the project #
            END_VAR

            +-------------------------------------------------------[$Once_in_task_event]--+

            +-------------------------------------------------------[$Text_in_task_event]--+

            +--------------------------------------------------------------<CALL>( Fast )--+

            +--------------------------------------------------------------<CALL>( Once )--+

            +--------------------------------------------------------------<CALL>( Text )--+

            +--<FUN>( Fast )---------------------------------------------------------------+

            +--[ ]( a )-----------------------------------------------------( )( shared )--+

            +--<FUN>( Once )---------------------------------------------------------------+

            +---------------------------------------------------------------( )( shared )--+

            +--<FUN>( Text )---------------------------------------------------------------+

            +------------------------------------------------------[MOV]( shared, FALSE )--+
            approximated variable a: it is spelled `Once_a` here
            approximated variable b: it is spelled `Once_b` here
            approximated variable a: it is spelled `Text_a` here
            approximated variable b: it is spelled `Text_b` here
            approximated task event: it runs when shared rises there, and in every scan here
        "#]],
    );
}

#[test]
fn variables_of_a_text_begin_again_at_each_call() {
    let variables = "inputVars a : INT\nlocalVars sum : INT";
    let function = unit(
        "function",
        "Twice",
        variables,
        "<ST><xhtml:p>sum := sum + a; Twice := sum + sum;</xhtml:p></ST>",
    );
    let function = function.replace("<interface>", "<interface><returnType><INT/></returnType>");
    let block = unit(
        "functionBlock",
        "Last",
        "inputVars a : INT\ntempVars t : INT\noutputVars y : INT",
        "<ST><xhtml:p>t := t + a; y := t;</xhtml:p></ST>",
    );
    let main = program(
        "n : INT\nl : Last",
        "inVariable 1 n\nblock 2 Twice a=1 / OUT\nblock 3 Last l a=2.OUT / y\noutVariable 4 from=3.y n",
    );
    check(
        &project("", &(function + &block + &main), ""),
        expect![[r#"
        FUNCTION_BLOCK [$Twice]
        VAR_INPUT
            a : INT := 0;
        END_VAR
        VAR
            sum : INT;
        END_VAR
        VAR_OUTPUT
            Twice : INT;  # what the function returns #
        END_VAR

        +-------------------------------------------------------------[MOV]( sum, 0 )--+
        +------------------------------------------------------[CALC]( sum, sum + a )--+
        +--------------------------------------------------[CALC]( Twice, sum + sum )--+
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$Last]
        VAR_INPUT
            a : INT := 0;
        END_VAR
        VAR
            t : INT;
        END_VAR
        VAR_OUTPUT
            y : INT;
        END_VAR

        +---------------------------------------------------------------[MOV]( t, 0 )--+
        +----------------------------------------------------------[CALC]( t, t + a )--+
        +---------------------------------------------------------------[MOV]( y, t )--+
        END_FUNCTION_BLOCK

        VAR
            n     : INT;
            l     : $Last;
            twice : INT;  # the result of Twice #
        END_VAR

        +------------------------------------------[$Twice]( a := n, Twice => twice )--+

        +----------------------------------------------------[$Last]( l, a := twice )--+

        +-------------------------------------------------------------[MOV]( n, l.y )--+
    "#]],
    );
}
