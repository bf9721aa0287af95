#pragma once
/// What a run carries from step to step, as tables of numbers by entity: a checkpoint writes them,
/// a restart reads them, on as many ranks as it likes.
#include <bit>
#include <concepts>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/field_use.hpp"
#include "core/types.hpp"

namespace brunt {

/// A state that does not fit: a table or row is missing, or of another shape.
class StateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Rows of numbers: value[k width] .. value[(k+1) width] belong to entity id[k], in any order.
/// Whole numbers are held as the double with the same bits.
struct StateTable {
  std::string name;
  int width = 0;
  std::vector<GlobalId> id;
  std::vector<Real> value;
};

/// The rows of one or more tables of one name, found by id.
class StateRows {
 public:
  StateRows() = default;
  /// parts  tables of one name and width, of the ranks that wrote them; outlive the rows.
  /// Throws StateError where a part is not of that width or its arrays are not of one length, and
  /// where an id has two rows that are not the same bits.
  explicit StateRows(std::vector<const StateTable*> parts);

  /// Values of an entity. Throws StateError naming table and id where there are none, or not
  /// `width` of them.
  std::span<const Real> row(GlobalId id, std::size_t width) const;
  bool has(GlobalId id) const;
  int width() const { return width_; }
  std::size_t size() const { return place_.size(); }

 private:
  struct Place {
    GlobalId id;
    const Real* values;
  };
  std::string name_;
  int width_ = 0;
  std::vector<Place> place_;  // by id, each once
};

/// All tables of a state.
class StateTables {
 public:
  /// Throws StateError as StateRows does.
  explicit StateTables(std::vector<StateTable> tables);
  StateTables(const StateTables&) = delete;
  StateTables& operator=(const StateTables&) = delete;

  bool has(const std::string& name) const { return rows_.count(name) > 0; }
  /// Throws StateError naming the table where there is none.
  const StateRows& rows(const std::string& name) const;

 private:
  std::vector<StateTable> tables_;
  std::map<std::string, StateRows> rows_;
};

/// Appends the values of an entity to its row.
class StateWriter {
 public:
  explicit StateWriter(std::vector<Real>& values) : values_(values) {}
  void operator()(const Real& value) { values_.push_back(value); }
  template <std::integral Whole>
  void operator()(const Whole& number) {
    values_.push_back(std::bit_cast<Real>(static_cast<std::uint64_t>(number)));
  }
  template <int Dim>
  void operator()(const Eigen::Matrix<Real, Dim, 1>& vector) {
    for (int c = 0; c < Dim; ++c) values_.push_back(vector[c]);
  }

 private:
  std::vector<Real>& values_;
};

/// Counts the values that an entity writes or reads.
class StateCounter {
 public:
  std::size_t count = 0;
  void operator()(const Real&) { ++count; }
  template <std::integral Whole>
  void operator()(const Whole&) {
    ++count;
  }
  template <int Dim>
  void operator()(const Eigen::Matrix<Real, Dim, 1>&) {
    count += slot_of(Dim);
  }
};

/// Takes the values of an entity from its row, in the order in which they were written.
class StateReader {
 public:
  explicit StateReader(std::span<const Real> row) : at_(row.data()) {}
  void operator()(Real& value) { value = *at_++; }
  template <std::integral Whole>
  void operator()(Whole& number) {
    number = static_cast<Whole>(std::bit_cast<std::uint64_t>(*at_++));
  }
  template <int Dim>
  void operator()(Eigen::Matrix<Real, Dim, 1>& vector) {
    for (int c = 0; c < Dim; ++c) vector[c] = *at_++;
  }

 private:
  const Real* at_;
};

/// Hands the saved ones of the values of an entity to its row.
template <class Row>
auto saved_in(Row& row) {
  return [&row](auto& value, FieldUse use) {
    if (use.saved) row(value);
  };
}
/// The same of fields, of which entity k has a value.
template <class Row>
auto saved_in(Row& row, std::size_t k) {
  return [&row, k](auto& field, FieldUse use) {
    if (use.saved) row(field[k]);
  };
}

/// Adds the table `name` with rows of the entities 0 .. n; none where n is 0.
/// id(k)  its id;  visit(row, k)  hands every value that k carries to row
template <class Id, class Visit>
void save_rows(const std::string& name, std::size_t n, const Id& id, const Visit& visit,
               std::vector<StateTable>& tables) {
  if (n == 0) return;
  StateTable table{name, 0, {}, {}};
  StateCounter counter;
  visit(counter, 0);
  table.width = static_cast<int>(counter.count);
  table.id.reserve(n);
  table.value.reserve(n * counter.count);
  StateWriter row(table.value);
  for (std::size_t k = 0; k < n; ++k) {
    table.id.push_back(id(k));
    visit(row, k);
  }
  tables.push_back(std::move(table));
}

/// Reads back what save_rows wrote, for the entities 0 .. n of whoever reads; id and visit as
/// there. Throws StateError naming table and id where a row is missing or of another length.
template <class Id, class Visit>
void load_rows(const std::string& name, std::size_t n, const Id& id, const Visit& visit,
               const StateTables& tables) {
  if (n == 0) return;
  StateCounter counter;
  visit(counter, 0);
  const StateRows& rows = tables.rows(name);
  for (std::size_t k = 0; k < n; ++k) {
    StateReader row(rows.row(id(k), counter.count));
    visit(row, k);
  }
}

/// Adds the table `name` of one row, with id 0. visit(row) hands every value to row.
template <class Visit>
void save_row(const std::string& name, const Visit& visit, std::vector<StateTable>& tables) {
  save_rows(
      name, 1, [](std::size_t) { return GlobalId{0}; }, [&](auto& row, std::size_t) { visit(row); },
      tables);
}

/// Reads back what save_row wrote; visit as there. Throws StateError.
template <class Visit>
void load_row(const std::string& name, const Visit& visit, const StateTables& tables) {
  load_rows(
      name, 1, [](std::size_t) { return GlobalId{0}; }, [&](auto& row, std::size_t) { visit(row); },
      tables);
}

}  // namespace brunt
