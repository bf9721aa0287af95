#pragma once
/// The visitor that writes a struct back as a tree: the resolved deck. Numbers are SI and the
/// shortest text that reads back as the same double.
#include <string>
#include <vector>

#include "core/schema.hpp"
#include "io/deck/node.hpp"

namespace brunt {

class Echo final : public Schema {
 public:
  explicit Echo(Geometry geometry);
  /// The tree of all that was visited.
  const Node& root() const { return stack_.front(); }

  Geometry geometry() const override { return geometry_; }
  void real(const Key& key, Real& value, const Quantity& quantity) override;
  void real(const Key& key, std::optional<Real>& value, const Quantity& quantity) override;
  void real_or_word(const Key& key, std::optional<Real>& value, const Quantity& quantity,
                    const char* word) override;
  void integer(const Key& key, int& value, const Range& range) override;
  void integer_or_word(const Key& key, std::optional<int>& value, const Range& range,
                       const char* word) override;
  void flag(const Key& key, bool& value) override;
  void text(const Key& key, std::string& value) override;
  void choice(const Key& key, int& index, std::span<const char* const> words) override;
  void list(const Key& key, std::vector<Real>& value, const Quantity& quantity, int size,
            bool allow_free) override;
  void list(const Key& key, std::optional<std::vector<Real>>& value, const Quantity& quantity,
            int size, bool allow_free) override;
  void direction(const Key& key, std::vector<Real>& value) override;
  void per_axis(const Key& key, std::optional<std::vector<Real>>& value,
                const Quantity& quantity) override;
  void points(const Key& key, std::vector<std::vector<Real>>& value,
              const Quantity& quantity) override;
  void integers(const Key& key, std::optional<std::vector<int>>& value, int size,
                const Range& range) override;
  void words(const Key& key, std::vector<std::string>& value,
             std::span<const char* const> words) override;
  void names(const Key& key, std::vector<std::string>& value, int size) override;
  void varying(const Key& key, std::optional<Varying>& value, const Quantity& quantity,
               std::span<const Varying::Over> over) override;
  void components(const Key& key, std::optional<std::vector<std::optional<Varying>>>& value,
                  const Quantity& quantity, std::span<const Varying::Over> over) override;
  void value(Real& value, const Quantity& quantity, const char* help) override;
  void value(int& index, std::span<const char* const> words, const char* help) override;
  void value(std::string& text, const char* help) override;
  void section(bool applies, const char* when, std::function<void(Schema&)> members) override;
  void require(bool, const char*, const std::string&) override {}

 protected:
  void visit_object(const Key& key, std::function<bool()> present, std::function<void()> create,
                    Members members) override;
  void visit_named(const Key& key, bool list_allowed, std::function<std::size_t()> size,
                   std::function<std::string(std::size_t)> name,
                   std::function<void(const std::string&)> add,
                   std::function<void(std::size_t, Schema&)> members, Members blank) override;
  void visit_one_or_more(const Key& key, std::function<std::size_t()> size,
                         std::function<void()> add,
                         std::function<void(std::size_t, Schema&)> members, Members blank) override;
  void visit_any_of(const Key& key, Members members) override;
  void visit_one_of(const Key& key, std::span<const Alternative> alternatives,
                    std::function<std::size_t()> index, std::function<void(std::size_t)> choose,
                    Members members, std::function<void(std::size_t, Schema&)> blank) override;
  void visit_varying_or_law(const Key& key, std::optional<Varying>& value, const Quantity& quantity,
                            std::span<const Varying::Over> over, std::function<bool()> is_law,
                            std::function<void(bool)> choose, Members members) override;

 private:
  void put(const std::string& key, Node value);
  Node members_of(const Members& members);

  Geometry geometry_;
  std::vector<Node> stack_;  ///< maps that are being written; a bare value replaces its map
};

}  // namespace brunt
