#pragma once
#include <optional>

#include "contact/contacts/friction_books.hpp"
#include "contact/contacts/memory.hpp"
#include "contact/manager/evaluation.hpp"
#include "contact/manager/manager.hpp"

namespace brunt {

/// When contact was last evaluated, and for which step lists have been renewed since.
struct LastEvaluation {
  Real dt = 0;           ///< [s] of the step that led there
  Real ahead = 0;        ///< [s] that the lists had to serve
  bool started = false;  ///< forces have been evaluated
  /// What the next evaluation looks ahead to, once its lists are there.
  std::optional<LookAhead> listed;
};

/// What the manager holds: each changes in verbs of its own.
template <int Dim>
struct ContactManager<Dim>::Implementation {
  explicit Implementation(ContactSetup<Dim> of_setup) : setup(std::move(of_setup)), search(setup) {}
  /// Lists, and tables but for Tables::kept, and the contacts of time 0. Collective.
  void begin(Tables tables);

  ContactSetup<Dim> setup;
  ContactSearch<Dim> search;
  Evaluation<Dim> evaluation;
  ContactMemory<Dim> memory;
  FrictionCheck<Dim> friction_check;
  LastEvaluation last;
};

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
