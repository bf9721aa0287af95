#pragma once
/// Keyword lines of Abaqus: names, parameters, and what is not read.
#include <map>
#include <string>
#include <string_view>

namespace brunt {

/// A name of a set, a surface or an instance. The case of its letters counts between quotes alone.
struct AbaqusLabel {
  std::string text;  ///< as it is written, without quotes
  std::string key;   ///< that all labels of the same thing share
};
AbaqusLabel abaqus_label(std::string_view written);

/// "*Element, type=C3D8R, elset=E".
class AbaqusKeyword {
 public:
  AbaqusKeyword() = default;
  explicit AbaqusKeyword(std::string_view line);

  /// In capitals, without blanks: "*ELEMENT", "*ELEMENTOUTPUT".
  const std::string& name() const { return name_; }
  /// The value of a parameter, which may be cut short (GEN); null: it is not there.
  const std::string* parameter(std::string_view name) const;

 private:
  std::string name_;
  std::map<std::string, std::string> parameters_;
};

/// What to do instead of a keyword that makes, moves or changes nodes or elements in a way that is
/// not read; "": it does not.
std::string instead_of_abaqus(std::string_view keyword);

}  // namespace brunt
