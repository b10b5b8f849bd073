#pragma once

#include "jsonld/compaction/inverse_context.hpp"
#include "jsonld/expansion/expansion.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace opal::json_ld {

/// Compaction Algorithm (JSON-LD 1.1 API, 6.1.2): IRIs become the terms of a context, and what the context says of a
/// term is left out of its values.
class Compactor {
 public:
  /// @param context  the value of a @context, or an object that has one.
  Compactor(const Options& options, const Json& context, const Place& place);

  /// The expanded document as one object, the context included.
  /// @param always_graph  the nodes stand in @graph, even if there is only one.
  Json compact_document(const Json& expanded, bool always_graph);

 private:
  using Property = const std::string*;
  /// The object that is being made, and what its entries depend on.
  struct Object {
    Json result = Json::object();
    ContextPtr type_scoped;                  ///< active before the contexts of its types
    const TermDefinition* holder = nullptr;  ///< of the property whose value it is
    bool reversed = false;                   ///< it is the value of @reverse
  };
  /// One value of a property on its way into an object.
  struct Item {
    const Json& expanded;
    Json compacted;
    const std::string& key;  ///< the property's term
    const TermDefinition* definition;
    bool as_array;

    bool in(const char* container) const { return definition && definition->contains(container); }
  };

  // compaction.cpp: elements
  Json compact(const ContextPtr& active, Property property, const Json& element);
  Json compact_array(const ContextPtr& active, Property property, const Json& element);
  Json compact_object(ContextPtr active, Property property, const Json& element);
  ContextPtr take_type_contexts(const ContextPtr& active, const Json& element);
  void compact_entry(Object& object, const ContextPtr& active, const std::string& iri, const Json& value);
  void compact_types(Object& object, const ContextPtr& active, const Json& value);
  void compact_reverse(Object& object, const ContextPtr& active, const Json& value);

  // properties.cpp: values of properties
  void compact_property(Object& object, const ContextPtr& active, const std::string& iri, const Json& values);
  Json& nest_of(Json& result, const ActiveContext& active, const TermDefinition* definition);
  Json& map_at(Json& result, const std::string& key) const;
  void add_wrapped(Json& result, const ContextPtr& active, Item item);
  void add_list(Json& result, const ContextPtr& active, Item item);
  void add_graph(Json& result, const ContextPtr& active, Item item);
  void add_to_map(Json& result, const ContextPtr& active, Item item);
  Json take_map_key(const ContextPtr& active, Item& item);
  Json take_property_index(const ContextPtr& active, Item& item);
  Json take_type_key(const ContextPtr& active, Item& item);

  // iri_compaction.cpp: names and plain values
  const InverseContext& inverse_of(const ContextPtr& active);
  /// IRI Compaction (6.2.2). @param value  what the IRI is a property of, if anything.
  std::string compact_iri(const ContextPtr& active, const std::string& iri, bool vocabulary,
                          const Json* value = nullptr, bool reverse = false);
  std::string alias(const ContextPtr& active, const std::string& keyword) { return compact_iri(active, keyword, true); }
  std::string find_name(const ContextPtr& active, const std::string& iri, bool vocabulary, const Json* value,
                        bool reverse);
  const std::string* select_term(const ContextPtr& active, const std::string& iri, const Json* value, bool reverse);
  std::vector<std::string_view> preferred(const ContextPtr& active, const std::string& wanted, const Json& value);
  /// Value Compaction (6.5) of a value object or of a node that is nothing but an @id.
  Json compact_value(const ContextPtr& active, const TermDefinition* definition, const Json& value);

  struct Inverse {
    ContextPtr active;  // held, so that nothing else can take its address
    std::unique_ptr<const InverseContext> inverse;
    std::array<std::unordered_map<std::string, std::string>, 2> names;  ///< found already, without a value; [1]: words
  };

  const Options& options_;
  ContextReader contexts_;
  Json context_;
  const Place& place_;
  ContextPtr initial_;
  std::map<const ActiveContext*, Inverse> inverses_;
};

/// The string under a key; nullopt: none, or something else. (An @id that looks like a keyword has become null.)
std::optional<std::string> text_of(const Json& object, const char* key);
/// A graph with nothing but a name and an index beside it.
bool is_graph_object(const Json& value);
/// Adds to the entry, which becomes an array when it gets a second value.
void add_compacted(Json& object, const std::string& key, Json value, bool as_array);

}  // namespace opal::json_ld
