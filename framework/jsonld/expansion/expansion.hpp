#pragma once

#include "jsonld/context/context.hpp"
#include "jsonld/context/place.hpp"

#include "jsonld/json_ld.hpp"

#include <map>
#include <optional>
#include <string>

namespace opal::json_ld {

/// Entry that keeps the source pointer of a node or value object; no keyword of JSON-LD.
inline constexpr const char* kPointer = "@pointer";

inline bool is_list(const Json& value) { return value.is_object() && value.contains("@list"); }
inline bool is_value(const Json& value) { return value.is_object() && value.contains("@value"); }
inline bool is_graph(const Json& value) { return value.is_object() && value.contains("@graph"); }
/// Nothing but an @id; the kept pointer does not count.
inline bool is_reference(const Json& value) {
  return value.is_object() && value.contains("@id") && value.size() == (value.contains(kPointer) ? 2u : 1u);
}
Json as_array(Json value);
/// Appends the value, or each of its elements.
void append(Json& array, Json value);
/// Appends to the array at the key, which is made if absent.
void add_value(Json& object, const std::string& key, Json value);

/// Expansion Algorithm (5.1.2): every term becomes an IRI, every value says what it is, every shorthand is
/// undone.
class Expander {
 public:
  /// @param framing  frames are expanded (JSON-LD 1.1 Framing, 4.1.2): their keywords count, and patterns may
  ///                 stand where documents have strings.
  explicit Expander(const Options& options, bool framing = false)
      : options_(options), contexts_(options), framing_(framing) {}

  Json expand_document(const Json& document);

 private:
  /// The object whose entries are being expanded.
  struct Object {
    Json result = Json::object();
    ContextPtr type_scoped;                 ///< active before the contexts of its types
    std::optional<std::string> value_type;  ///< its @type, in case it is a value object
  };
  /// The term or IRI whose values are being expanded; null at the top of a document.
  using Property = const std::string*;
  using Nests = std::map<std::string, const Json*>;

  // expansion.cpp: elements
  ContextPtr initial_context();
  Json expand(const ContextPtr& active, Property property, const Json& element, const Place& place,
              bool from_map = false);
  Json expand_array(const ContextPtr& active, Property property, const Json& element, const Place& place,
                    bool from_map);
  Json expand_scalar(const ContextPtr& active, Property property, const Json& element, const Place& place,
                     const TermDefinition* definition);
  Json expand_object(ContextPtr active, Property property, const Json& element, const Place& place, bool from_map);
  bool keeps_context(const ActiveContext& active, const Json& element) const;
  ContextPtr take_context(const ContextPtr& active, const Json& element, const Place& place);
  ContextPtr take_type_contexts(const ContextPtr& active, const Json& element, const Place& place);
  std::optional<std::string> value_type(const ActiveContext& active, const Json& element) const;
  Json finish(Json result, Property property, const Place& place) const;
  Json finish_value(Json result, const Place& place) const;
  Json finish_container(Json result, const Place& place) const;
  Json mark(Json object, const Place& place) const;

  // entries.cpp: entries of an object
  void expand_entries(Object& object, const ContextPtr& active, Property property, const Json& element,
                      const Place& place);
  void expand_nested(Object& object, const ContextPtr& active, const std::string& key, const Json& nested,
                     const Place& place);
  void expand_property(Object& object, const ContextPtr& active, const std::string& key, const std::string& iri,
                       const Json& value, const Place& place);
  Json expand_property_value(const ContextPtr& active, const std::string& key, const Json& value, const Place& place);
  void add_reversed(Json& result, const std::string& iri, Json values, const Place& place) const;

  // keywords.cpp: entries whose key is a keyword
  void expand_keyword(Object& object, const ContextPtr& active, Property property, const std::string& keyword,
                      const Json& value, const Place& place);
  Json expand_id(const ActiveContext& active, const Json& value, const Place& place) const;
  void expand_types(Json& result, const ActiveContext& active, const Json& value, const Place& place) const;
  Json expand_included(const ContextPtr& active, const Json& value, const Place& place);
  void expand_list(Json& result, const ContextPtr& active, Property property, const Json& value, const Place& place);
  void expand_set(Json& result, const ContextPtr& active, Property property, const Json& value, const Place& place);
  void expand_reverse(Object& object, const ContextPtr& active, const Json& value, const Place& place);
  void expand_value_entry(Object& object, const Json& value, const Place& place) const;

  // maps.cpp: containers that are objects
  Json expand_language_map(const ActiveContext& active, const TermDefinition& definition, const Json& value,
                           const Place& place) const;
  Json expand_index_map(const ContextPtr& active, const TermDefinition& definition, const std::string& key,
                        const Json& value, const Place& place);
  ContextPtr map_context(const ContextPtr& active, const TermDefinition& definition, const std::string& index,
                         const Place& place);
  void add_index(Json& item, const ActiveContext& active, const TermDefinition& definition, const std::string& index,
                 const Place& place) const;
  void add_property_index(Json& item, const ActiveContext& active, const std::string& index_key,
                          const std::string& index, const Place& place) const;

  // framing_keywords.cpp: what only frames may say
  bool expand_frame_keyword(Object& object, const ContextPtr& active, Property property, const std::string& keyword,
                            const Json& value, const Place& place);
  Json expand_default(const ContextPtr& active, Property property, const Json& value, const Place& place);
  Json expand_id_pattern(const ActiveContext& active, const Json& value, const Place& place) const;
  Json expand_type_pattern(const ActiveContext& active, const Json& value, const Place& place) const;
  static Json expand_text_pattern(const std::string& keyword, const Json& value, const Place& place);

  // value.cpp: scalars
  Json expand_value(const ActiveContext& active, const TermDefinition* definition, const Json& value,
                    const Place& place) const;
  /// JSON-LD drops, or takes for an IRI, what the context does not define.
  void refuse_unknown(const ActiveContext& active, const std::string& word, const std::optional<std::string>& iri,
                      const Place& place) const;
  /// The IRI that a vocabulary word (a type, a value of an @vocab-typed term) stands for.
  Json expand_word(const ActiveContext& active, const std::string& word, const Place& place) const;

  const Options& options_;
  ContextReader contexts_;
  bool framing_;
};

}  // namespace opal::json_ld
