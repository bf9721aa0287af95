#pragma once
/// Keyword lines of LS-DYNA: names, widths of columns, and what is not read.
#include <cstddef>
#include <string>
#include <string_view>

namespace brunt {

/// Columns of the numbers of a card: nodes and elements, coordinates, all others.
struct DynaColumns {
  std::size_t id = 8, real = 16, wide = 10;
  const char* hint = "";  ///< behind messages that a number is none: which columns are read
};

/// "*NODE %", "*ELEMENT_SOLID (ten nodes format)": its name and its columns.
struct DynaKeyword {
  std::string name;  ///< in capitals, up to a blank or a bracket: the rest is a hint of LS-PrePost
  DynaColumns columns;
};
/// usual  columns where the keyword does not say its own, by %, + or -
DynaKeyword dyna_keyword(std::string_view line, const DynaColumns& usual);

/// Columns of the whole file, by *KEYWORD's LONG= and I10=.
DynaColumns columns_of_file(std::string_view keyword_line);

/// What to do instead where a keyword makes, moves or changes nodes or elements in a way that is
/// not read; null: it does not.
const char* instead_of_dyna(std::string_view keyword);

/// Lines that follow the nodes of a shell.
struct ShellLines {
  int always = 0;
  int higher = 0;  ///< more where it has nodes between its corners
};
/// keyword  *ELEMENT_SHELL with any options. False: their lines are not known.
bool find_shell_lines(std::string_view keyword, ShellLines& lines);

}  // namespace brunt
