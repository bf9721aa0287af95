#pragma once
#include <string>
#include <vector>

namespace brunt {

/// What the command line says about a trade.
struct TradeArguments {
  std::string deck;
  std::vector<std::string> overrides;  ///< "KEY=VALUE" of all variants
  std::vector<std::string> vary;       ///< "KEY=V1,V2"
  std::string against;                 ///< exact, finest, reference; empty: exact, else finest
  bool one_at_a_time = false;
  bool grid = false;  ///< the default
  int jobs = 1, repeat = 3, threads = 1;
  std::string out;  ///< empty: <deck>.trade beside where brunt was started
  bool force = false, quiet = false, json = false;
};

/// `brunt trade`: runs the variants, writes trade.csv, trade.json, trade.svg and trade.png, prints
/// the tables. Returns the exit status: of the worst run.
int trade_command(const TradeArguments& arguments);

}  // namespace brunt
