#pragma once
#include <string>

namespace brunt {

/// `brunt explain [KEY]`: unit, range, default and help of a key; all keys without one.
int explain_command(const std::string& key);
/// What `brunt schema` prints: the JSON schema of decks, the reference manual of their keys, or
/// what the columns of history.csv and the fields of frames are.
enum class SchemaPage { json, keys, columns };
int schema_command(SchemaPage page);

}  // namespace brunt
