/** The program of the walkthrough: `motor.clad` of the examples. */
export const EXAMPLE = `# A motor starter: \`start\` and \`stop\` are push buttons, and the motor seals itself in.
  After five seconds of running it is warm: \`ready\` lets the rest of the plant go on. #

VAR_INPUT
    start, stop : BOOL;
END_VAR

VAR_OUTPUT
    run, ready : BOOL;
END_VAR

VAR
    warmup : TON;
END_VAR

# Start, held by the motor's own contact until stop is pressed #
+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |

# Warm-up #
+--[ ]( run )-----------------------------[TON]( warmup, T#5s )--( )( ready )--+
`;
