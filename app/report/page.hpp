#pragma once
#include <string>
#include <utility>
#include <vector>

#include "io/history.hpp"
#include "io/summary.hpp"

namespace brunt {

/// What a report shows of one run.
struct RunReport {
  std::string title;
  RunSummary summary;
  History history;
  std::string deck;                                           ///< the resolved deck
  std::vector<std::pair<std::string, std::string>> pictures;  ///< name, bytes of a PNG
};

/// One page of HTML that needs nothing beside it: how the run ended, measures, charts over time,
/// pictures, the energy ledger at the end, warnings, what it cost, the deck.
std::string html_page(const RunReport& report);

/// Bytes as text of 64 letters (RFC 4648), for pictures within a page.
std::string base64(const std::string& bytes);

}  // namespace brunt
