#pragma once
/// Conditions over columns of the history: "= body.ball.velocity.z > 0 && time > 1e-5".
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// An expression in which names of columns stand for their values [SI]. A name may hold dots and
/// dashes: of the names that begin at a place the longest counts, `contact.a-b.force.x` before
/// `contact.a - b...`.
class ColumnExpression {
 public:
  /// text  with "=", parameters put in;  columns  names of all that there are. Throws
  /// std::invalid_argument with what is wrong.
  ColumnExpression(const std::string& text, const std::vector<std::string>& columns);
  ~ColumnExpression();
  ColumnExpression(ColumnExpression&&) noexcept;
  ColumnExpression& operator=(ColumnExpression&&) noexcept;

  /// row  values of all columns
  Real operator()(std::span<const Real> row) const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

/// Names with a dot in an expression that are no columns, in order.
std::vector<std::string> unknown_columns_in(const std::string& text,
                                            const std::vector<std::string>& columns);

}  // namespace brunt
