#pragma once
#include "app/cli/run_arguments.hpp"
#include "app/deck/deck.hpp"
#include "core/errors.hpp"

namespace brunt {

/// The deck of a run, with --until in place; a warning where that is after the end.
/// print  warnings, on stderr. Throws DeckError with all that is wrong (load_or_tell_all).
LoadedDeck load_run(const RunArguments& arguments, bool print);

/// The same problems, those of --until under the name that the user knows.
DeckError as_called(const DeckError& error, const RunArguments& arguments);

}  // namespace brunt
