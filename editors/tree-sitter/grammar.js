/// <reference types="tree-sitter-cli/dsl" />
// Ladder diagrams as plain text, for editors that colour, fold and select by Tree-sitter.
//
// Nodes are named so that no query needs a predicate: each editor knows others. What the text means, and what is wrong
// with it, is for the language server to say.

// A word in any case.
const inAnyCase = (text) =>
  new RegExp([...text].map((c) => (/[a-z]/i.test(c) ? `[${c.toUpperCase()}${c.toLowerCase()}]` : c)).join(''));
const oneOf = (...texts) => choice(...texts.map(inAnyCase));

// A keyword: in the tree it stands in capitals.
const word = (text) => alias(inAnyCase(text), text);

const list = (item) => seq(item, repeat(seq(',', item)));

const DATES = ['D', 'DATE', 'TOD', 'TIME_OF_DAY', 'DT', 'DATE_AND_TIME'];
const DURATIONS = ['T', 'TIME', 'LTIME'];
const NUMBERS = [
  ...['BOOL', 'BYTE', 'WORD', 'DWORD', 'LWORD', 'SINT', 'INT', 'DINT', 'LINT', 'USINT', 'UINT', 'UDINT', 'ULINT'],
  ...['REAL', 'LREAL'],
];
const BLOCKS = ['TON', 'TOF', 'TP', 'RTO', 'RTOF', 'CTU', 'CTD', 'CTUD', 'CTC', 'SR', 'RS'];
const TYPES = [...NUMBERS, ...BLOCKS, 'TIME', 'DATE', 'TOD', 'DT', 'TIME_OF_DAY', 'DATE_AND_TIME', 'STRING'];
const SECTIONS = ['VAR', 'VAR_INPUT', 'VAR_OUTPUT', 'VAR_IN_OUT', 'VAR_GLOBAL', 'VAR_EXTERNAL'];

const DURATION = /([0-9][0-9_]*(\.[0-9_]+)?([dDhHmMsS]|[mMuUnN][sS])_?)+/;
const NUMBER = /[0-9][0-9_]*(\.[0-9][0-9_]*)?([eE][+-]?[0-9]+)?/;
const BASED = /(2|8|16)#[0-9A-Fa-f_]+/;

const BINARY = [
  ['OR'],
  ['XOR'],
  ['AND'],
  ['=', '<>'],
  ['<', '<=', '>', '>='],
  ['SHL', 'SHR'],
  ['+', '-'],
  ['*', '/', 'MOD'],
];
const POWER = BINARY.length + 1;
const UNARY = POWER + 1;
const operator = (text) => (/[A-Z]/.test(text) ? word(text) : text);

module.exports = grammar({
  name: 'clad',

  // A line end counts only where one may end a line of the drawing; there the scanner takes it. One that comes before the
  // `)` of a list ends the list as well: so a rung that is being typed takes nothing from the next.
  externals: ($) => [$._line_end, $._unclosed, $._never],

  extras: ($) => [/[ \t\r\n]/, $.comment],

  word: ($) => $.identifier,

  supertypes: ($) => [$.expression],

  rules: {
    source_file: ($) => repeat(choice($._part, $.block_definition)),

    _part: ($) => choice($.var_section, $.type_section, $.network, $.rail_line),

    comment: () => /#[^#]*#/,

    // --- The drawing -------------------------------------------------------------------------------------------

    // A rung with a `\` goes on on the rung below it.
    network: ($) => prec.right(choice($.rung, seq($._rungs_that_go_on, optional($.rung)))),

    _rungs_that_go_on: ($) =>
      choice(
        alias($._rung_that_goes_on, $.rung),
        seq($._rungs_that_go_on, choice($.rail_line, alias($._rung_that_goes_on, $.rung))),
      ),

    rail_line: ($) => seq($._rails, $._line_end),

    _rails: ($) => repeat1($.rail),

    rung: ($) => seq($._before_down, $._line_end),

    _rung_that_goes_on: ($) =>
      seq(
        optional(choice($._rails, $._before_down)),
        $.down_connector,
        repeat(choice($.rail, $._element, $.down_connector)),
        $._line_end,
      ),

    _before_down: ($) => seq(optional($._rails), $._element, repeat(choice($.rail, $._element))),

    _element: ($) => choice($.wire, $.rail_connector, $.up_connector, $.logical_block, $.coil_block, $.function_block),

    wire: () => /-+/,
    rail_connector: () => '+',
    rail: () => '|',
    down_connector: () => '\\',
    up_connector: () => '/',

    // --- Blocks ------------------------------------------------------------------------------------------------

    // A parenthesis after the first part is the list of operands.
    logical_block: ($) => prec.right(seq(alias($._logical_head, $.head), optional($.operand_list))),
    coil_block: ($) => prec.right(seq(alias($._coil_head, $.head), optional($.operand_list))),
    function_block: ($) =>
      prec.right(
        choice(
          seq(alias($._function_head, $.head), optional($.operand_list)),
          seq(alias($._jump_head, $.head), optional(alias($._label_list, $.operand_list))),
        ),
      ),

    _logical_head: ($) => seq('[', optional($._instruction), ']'),
    _coil_head: ($) => seq('(', optional($._instruction), ')'),
    _function_head: ($) => seq('<', optional($._instruction), '>'),
    _jump_head: ($) => seq('<', alias(oneOf('LBL', 'JMP', 'FUN', 'CALL'), $.mnemonic), '>'),

    _instruction: ($) => choice(alias($.identifier, $.mnemonic), alias('/', $.mnemonic), $.block_name),

    block_name: () => /\$[\p{XID_Start}_]\p{XID_Continue}*/,

    operand_list: ($) =>
      seq('(', optional(list(choice($.expression, $.named_operand))), choice(')', seq(optional(','), $._unclosed))),
    _label_list: ($) => seq('(', alias($.identifier, $.label), choice(')', $._unclosed)),

    named_operand: ($) =>
      seq(field('name', alias($.identifier, $.parameter)), choice(':=', '=>'), field('value', $.expression)),

    // --- Expressions -------------------------------------------------------------------------------------------

    expression: ($) =>
      choice(
        $.identifier,
        $.system,
        $.constant,
        $.address,
        $.boolean,
        $.number,
        $.duration,
        $.date,
        $.string,
        $.member_expression,
        $.index_expression,
        $.call_expression,
        $.unary_expression,
        $.binary_expression,
        $.parenthesized_expression,
      ),

    member_expression: ($) =>
      prec(
        UNARY + 1,
        seq(field('object', $.expression), '.', field('member', alias(choice($.identifier, $.integer), $.member))),
      ),
    integer: () => /[0-9]+/,

    index_expression: ($) =>
      prec(UNARY + 1, seq(field('object', $.expression), '[', list(choice($.expression, $.range)), ']')),
    range: ($) => seq($.expression, '..', $.expression),

    call_expression: ($) =>
      prec(
        UNARY + 1,
        seq(
          field('function', alias(choice($.identifier, oneOf('AND', 'OR', 'XOR', 'MOD', 'SHL', 'SHR')), $.function)),
          $.arguments,
        ),
      ),
    arguments: ($) => seq('(', optional(list($.expression)), ')'),

    unary_expression: ($) => prec(UNARY, seq(choice('-', word('NOT')), $.expression)),

    binary_expression: ($) =>
      choice(
        ...BINARY.map((operators, strength) =>
          prec.left(strength + 1, seq($.expression, choice(...operators.map(operator)), $.expression)),
        ),
        prec.right(POWER, seq($.expression, '^', $.expression)),
      ),

    parenthesized_expression: ($) => seq('(', $.expression, ')'),

    system: () => inAnyCase('SYS'),
    constant: () => inAnyCase('PI'),
    boolean: () => oneOf('TRUE', 'FALSE'),

    // `%IX0.3`
    address: () => /%[A-Za-z][A-Za-z0-9]*(\.[0-9]+)*/,

    // The `#` of a literal stands after a number or the name of a type, and a value follows. Any other opens a comment.
    number: () =>
      token(
        choice(
          NUMBER,
          BASED,
          seq(oneOf(...NUMBERS), '#', choice(seq(optional(/[+-]/), choice(NUMBER, BASED)), oneOf('TRUE', 'FALSE'))),
        ),
      ),
    duration: () => token(choice(DURATION, seq(oneOf(...DURATIONS), '#', optional(/[+-]/), DURATION))),
    date: () => token(seq(oneOf(...DATES), '#', /[0-9]([0-9.:_-]*[0-9])?/)),

    string: ($) => seq("'", repeat(choice($._string_text, $.escape)), token.immediate("'")),
    _string_text: () => token.immediate(prec(1, /[^'$\r\n]+/)),
    escape: () => token.immediate(prec(1, /\$([0-9A-Fa-f]{2}|[^\r\n])/)),

    // --- Declarations ------------------------------------------------------------------------------------------

    var_section: ($) =>
      seq(
        field('kind', choice(...SECTIONS.map(word))),
        repeat(choice(word('RETAIN'), word('CONSTANT'), word('NON_RETAIN'))),
        repeat($.declaration),
        word('END_VAR'),
      ),

    declaration: ($) =>
      seq(
        list(field('name', $.identifier)),
        optional(seq(word('AT'), $.address)),
        ':',
        field('type', $._type),
        optional($._initial_value),
        ';',
      ),

    type_section: ($) => seq(word('TYPE'), repeat($.type_declaration), word('END_TYPE')),

    type_declaration: ($) =>
      seq(
        field('name', alias($.identifier, $.type_name)),
        ':',
        field('type', choice($._type, $.structure, $.enumeration)),
        optional($._initial_value),
        ';',
      ),

    structure: ($) => seq(word('STRUCT'), repeat($.declaration), word('END_STRUCT')),

    enumeration: ($) => seq('(', list($.enumeration_value), ')'),
    enumeration_value: ($) => seq(field('name', $.identifier), optional($._initial_value)),

    _type: ($) => choice($._type_name, $.array_type),

    array_type: ($) => seq(word('ARRAY'), '[', list($.range), ']', word('OF'), $._type_name),

    _type_name: ($) =>
      choice(
        seq($.builtin_type, optional($.bounds)),
        alias($.identifier, $.type_name),
        $.block_name,
      ),

    // `INT(0..100)`, `STRING[80]`
    bounds: ($) => choice(seq('(', $.range, ')'), seq('[', $.expression, ']')),

    builtin_type: () => oneOf(...TYPES),

    _initial_value: ($) => seq(':=', field('value', $._value)),

    _value: ($) => choice($.expression, $.array_value, $.structure_value),

    array_value: ($) => seq('[', optional(list(choice($._value, $.repeated_value))), ']'),
    // `6(0.0)`: six of that value; `6()`: six of the type's own.
    repeated_value: ($) => seq($.number, '(', optional(list($._value)), ')'),
    structure_value: ($) => seq('(', list($.member_value), ')'),
    member_value: ($) => seq(field('name', alias($.identifier, $.member)), ':=', field('value', $._value)),

    // --- Blocks of one's own -----------------------------------------------------------------------------------

    block_definition: ($) =>
      seq(
        word('FUNCTION_BLOCK'),
        choice(seq('[', $.block_name, ']'), seq('(', $.block_name, ')'), seq('<', $.block_name, '>')),
        $._line_end,
        repeat($._part),
        word('END_FUNCTION_BLOCK'),
      ),

    // Last: of two tokens that match the same text the first is taken, and a keyword is a name, too.
    identifier: () => /[\p{XID_Start}_]\p{XID_Continue}*/,
  },
});
