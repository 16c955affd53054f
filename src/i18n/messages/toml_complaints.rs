//! Complaints of the TOML parser. In English these are the beginnings of its own words.

texts! {
    string_values_must_be_quoted: "string values must be quoted", "textos precisam de aspas";
    unexpected_key_or_value: "unexpected key or value", "há algo a mais depois do valor";
    invalid_unquoted_key: "invalid unquoted key", "uma chave só tem letras sem acento, algarismos, - e _";
    key_with_no_value: "key with no value", "chave sem valor";
    unclosed_array: "unclosed array", "falta fechar uma lista com ]";
    unclosed_table: "unclosed table", "falta fechar uma seção com ]";
    unclosed_inline_table: "unclosed inline table", "falta fechar uma tabela com }";
    missing_comma_between_array_elements: "missing comma between array elements", "falta uma vírgula entre os elementos da lista";
    extra_comma_in_array: "extra comma in array", "há uma vírgula a mais na lista";
    integer_number_overflowed: "integer number overflowed", "inteiro grande demais";
    floating_point_number_overflowed: "floating-point number overflowed", "número grande demais";
    unexpected_leading_zero: "unexpected leading zero", "zero a mais no começo do número";
    invalid_float: "invalid float", "número inválido";
    invalid_integer: "invalid integer", "inteiro inválido";
    invalid_mantissa: "invalid mantissa", "falta um dígito antes do ponto";
    invalid_fraction: "invalid fraction", "falta um dígito depois do ponto";
    invalid_basic_string: "invalid basic string", "falta fechar um texto com aspas";
    cannot_recurse_further: "cannot recurse further", "aninhamento profundo demais";
}
