#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace opal {

/// A mention of another node, and where it stands in the source.
struct GraphReference {
  std::string id;
  std::string place;
};

/// Typed, checked access to one node of a flattened JSON-LD graph. Every complaint names the file, the place, what
/// was found and what was expected.
class GraphNode {
 public:
  /// @param position  in the graph.
  GraphNode(const nlohmann::json& node, std::size_t position, const std::string& source);

  const std::string& id() const { return *id_; }
  std::size_t position() const { return position_; }
  std::string place() const { return place_of(*node_); }
  /// "Circle 'c1'", for messages.
  std::string description() const;
  const nlohmann::json& content() const { return *node_; }

  std::vector<std::string> types() const;  ///< full IRIs, sorted
  /// The first type that passes a test; null: none does.
  template <class Test>
  const std::string* find_type(Test test) const {
    for (const nlohmann::json& type : *types_)
      if (test(type.get_ref<const std::string&>())) return type.get_ptr<const std::string*>();
    return nullptr;
  }
  template <class Test>
  bool any_type(Test test) const {
    return find_type(test) != nullptr;
  }
  bool has_type(std::string_view iri) const;
  bool has(std::string_view iri) const { return node_->contains(iri); }

  std::optional<double> number(std::string_view iri) const;
  double required_number(std::string_view iri) const;
  std::optional<std::string> text(std::string_view iri) const;

  std::vector<GraphReference> references(std::string_view iri) const;  ///< by id, each once
  std::optional<GraphReference> reference(std::string_view iri) const;
  GraphReference required_reference(std::string_view iri) const;

  std::vector<GraphReference> reference_list(std::string_view iri) const;  ///< in order, repeats kept
  std::vector<double> number_list(std::string_view iri) const;
  std::vector<std::string> text_list(std::string_view iri) const;

  /// @throws MapError "SOURCE: PLACE: message".
  [[noreturn]] void fail(const std::string& message) const { fail_at(place(), message); }
  [[noreturn]] void fail_at(const std::string& place, const std::string& message) const;

 private:
  std::string place_of(const nlohmann::json& value) const;
  GraphReference reference_in(const nlohmann::json& value, std::string_view iri) const;
  double number_in(const nlohmann::json& value, std::string_view iri) const;
  const nlohmann::json* single_value(std::string_view iri) const;
  const nlohmann::json* single_list(std::string_view iri) const;
  [[noreturn]] void fail_missing(std::string_view iri) const;

  const nlohmann::json* node_;
  const std::string* id_;
  const nlohmann::json* types_;
  std::size_t position_;
  const std::string* source_;
};

/// The nodes of a document by id.
class Graph {
 public:
  Graph(nlohmann::json flattened, std::string source);
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  const std::vector<GraphNode>& nodes() const { return nodes_; }
  const GraphNode* find(const std::string& id) const;
  /// @throws MapError if the document does not define what `from` refers to.
  const GraphNode& at(const GraphReference& reference, const GraphNode& from) const;

 private:
  nlohmann::json flattened_;
  std::string source_;
  std::vector<GraphNode> nodes_;
  std::unordered_map<std::string_view, std::size_t> positions_;
};

/// The same JSON without the "@pointer" entries by which messages find their places.
nlohmann::json without_pointers(const nlohmann::json& value);

}  // namespace opal
