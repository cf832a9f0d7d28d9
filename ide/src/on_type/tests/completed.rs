//! A block, a branch or a rung that is completed.

use super::check;
use expect_test::expect;

#[test]
fn a_completed_block_draws_its_network() {
    check(
        "+--\\--[ ]( start )$0--\\--( )( run )--+\n|  /--[ ]( run )--/\n",
        expect![[r#"
            +--\--[ ]( start )--\----------------------------------------------( )( run )--+
            |  /--[ ]( run )----/                                                          |

        "#]],
    );
    check(
        "+--[ ]( a )$0",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[ ]( a )--<RET>$0--+\n",
        expect![[r#"
            +--[ ]( a )-------------------------------------------------------------<RET>--+

        "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( bbbbbbb )--/$0\n",
        expect![[r#"
            +--\--[ ]( a )--------\----------------------------------------------( )( y )--+
            |  /--[ ]( bbbbbbb )--/                                                        |

        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+$0\n\n+-[ ]( x )-( )( z )-+\n",
        expect![[r#"
            +--[ ]( a )----------------------------------------------------------( )( y )--+

            +-[ ]( x )-( )( z )-+

        "#]],
    );
}

#[test]
fn what_is_half_typed_stays() {
    check(
        "+--[ ]( a )--( )$0--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--[CALC]( y, (a + b)$0 --( )( x )--+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+--\\--[ ]( a )--\\--( )( y )$0--+\n|  /--[ ]( b )\n",
        expect![[r#"
            nothing
        "#]],
    );
    check(
        "+--[ ]( a )$0-------------[TON]( t\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "# a (b)$0 #\n+-[ ]( a )-( )( y )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+-[ ]( a )-( )( y )-+  # (c)$0 #\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+-[ ]( a )-[MOV]( y, 'x)$0' )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "+-[/$0]( a )-( )( y )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
    check(
        "# open +-[ ]( a )$0-( )( y )-+\n",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn a_branch_is_drawn_as_it_is_typed() {
    check(
        "+--\\\n$0--[ ]( a )--( )( y )--+\n",
        expect![[r#"
        +--\--[ ]( a )--( )( y )--+
        |  /--

    "#]],
    );
    check(
        "+--[ ]( a )--\\\n$0 --[ ]( b )--( )( y )--+\n\n+--[ ]( x )--+\n",
        expect![[r#"
            +--[ ]( a )--\--[ ]( b )--( )( y )--+
            |            /--

            +--[ ]( x )--+

        "#]],
    );
    check(
        "+--\\--[ ]( a )--( )( y )--+\n|  /--[ ]( b )/$0\n",
        expect![[r#"
            +--\--[ ]( a )--\----------------------------------------------------( )( y )--+
            |  /--[ ]( b )--/                                                              |

        "#]],
    );
    check(
        "+--\\--[ ]( first )--[ ]( second )--( )( y )--+\n|  /--[ ]( b )--/$0\n",
        expect![[r#"
            +--\--[ ]( first )--\--[ ]( second )---------------------------------( )( y )--+
            |  /--[ ]( b )------/                                                          |

        "#]],
    );
    check(
        "+--\\--[ ]( first )--[ ]( second )--( )( y )--+\n|  /--[ ]( b )-----------------------/$0\n",
        expect![[r#"
            +--\--[ ]( first )--[ ]( second )--\---------------------------------( )( y )--+
            |  /--[ ]( b )---------------------/                                           |

        "#]],
    );
    check(
        "+--\\--[ ]( a )\n|  /--[ ]( b )/$0\n\n+--[ ]( x )------------------( )( z )--+\n",
        expect![[r#"
            +--\--[ ]( a )--\--
            |  /--[ ]( b )--/

            +--[ ]( x )------------------( )( z )--+

        "#]],
    );
    check(
        "+--[ ]( s )--\\--( )( y )--( )( z )--+\n             /--( )( x )/$0\n",
        expect![[r#"
            +--[ ]( s )--\------------------------------------------( )( y )--\--( )( z )--+
            |            /------------------------------------------( )( x )--/            |

        "#]],
    );
    // The `/` of the branch was there.
    check(
        "+--\\--[ ]( a )--( )( y )--+\n|  /--/$0\n",
        expect![[r#"
            +--\--[ ]( a )--( )( y )--+
            |  /--

        "#]],
    );
    // One that has a partner, and one without a branch.
    check(
        "+--[ ]( a )--( )( y )--+\n/$0\n",
        expect![[r#"
        nothing
    "#]],
    );
}

#[test]
fn nothing_is_drawn_where_the_formatter_is_switched_off() {
    check(
        "# ladder: fmt off #\n+-[ ](a)-( )(b)-+\n$0",
        expect![[r#"
            nothing
        "#]],
    );
    check(
        "# ladder: fmt off #\n+--\\--[ ]( start )$0--\\--( )( run )--+\n|  /--[ ]( run )--/\n",
        expect![[r#"
            nothing
        "#]],
    );
    check(
        "#ladder: fmt off#\n+-[ ](a)-( )(b)-+\n# ladder: fmt on #\n+-[ ](a)-( )(b)-+\n$0",
        expect![[r#"
            #ladder: fmt off#
            +-[ ](a)-( )(b)-+
            # ladder: fmt on #
            +--[ ]( a )----------------------------------------------------------( )( b )--+
            +--
        "#]],
    );
}
