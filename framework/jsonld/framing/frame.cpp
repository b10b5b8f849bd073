// JSON-LD 1.1 Framing, 4.1: from documents and frames to framed documents.
#include "jsonld/compaction/compaction.hpp"
#include "jsonld/context/iri.hpp"
#include "jsonld/framing/framing.hpp"

#include <unordered_map>
#include <utility>

namespace opal::json_ld {
namespace {

using Counts = std::unordered_map<std::string, int>;

void count_blank_nodes(const Json& value, Counts& counts) {
  if (value.is_string()) {
    if (is_blank_node(value.get_ref<const std::string&>())) ++counts[value.get<std::string>()];
    return;
  }
  if (!value.is_structured() || is_value(value)) return;
  for (const Json& entry : value) count_blank_nodes(entry, counts);
}

void drop_single_names(Json& value, const Counts& counts) {
  if (!value.is_structured() || is_value(value)) return;
  if (value.is_object() && value.contains("@id") && value["@id"].is_string()) {
    const auto count = counts.find(value["@id"].get_ref<const std::string&>());
    if (count != counts.end() && count->second == 1) value.erase("@id");
  }
  for (Json& entry : value) drop_single_names(entry, counts);
}

/// The one object of an expanded frame; a frame that says nothing asks for every node.
Json expanded_frame(const Json& frame, const Options& options) {
  if (!frame.is_object()) throw JsonLdError("invalid frame", "frame", "expected an object");
  Json expanded = Expander(options, true).expand_document(frame);
  if (expanded.empty()) expanded.push_back(Json::object());
  return single_frame(expanded);
}

/// Whether the frame has @graph at its top, under whatever name: then it asks for the default graph alone.
bool asks_for_default_graph(const Json& frame, const Options& options) {
  ContextReader contexts(options);
  ContextUse use;
  use.base = options.base;
  const Place place("frame#");
  const ContextPtr active = contexts.read(contexts.initial(), frame.value("@context", Json::object()), place, use);
  for (const auto& [key, value] : frame.items())
    if (expand_iri(*active, key, {true, false}) == "@graph") return true;
  return false;
}

/// Runs a step that reads the frame, so that its errors name it.
template <class Step>
auto reading_frame(Step step) {
  try {
    return step();
  } catch (const JsonLdError& error) {
    const std::string message = error.what(), start = ": " + error.code() + ": ";
    const std::size_t detail = message.find(start);
    const bool named = error.pointer().rfind("frame", 0) == 0;
    throw JsonLdError(error.code(), named ? error.pointer() : "frame#" + error.pointer(),
                      detail == std::string::npos ? message : message.substr(detail + start.size()));
  }
}

}  // namespace

void add_merged_graph(NodeMap& nodes) {
  if (nodes.graphs().size() == 1) {  // as ever in maps: no copy
    auto only = nodes.graphs().extract(nodes.graphs().begin());
    only.key() = kMergedGraph;
    nodes.graphs().insert(std::move(only));
    return;
  }
  NodeGraph merged;
  for (const auto& [name, graph] : nodes.graphs())
    for (const auto& [id, node] : graph) {
      Node& target = node_of(merged, id);
      for (const auto& [key, values] : node.json().items()) {
        if (is_keyword(key) && key != "@type") {
          target.json()[key] = values;
          continue;
        }
        target.values(key);
        for (const Json& value : values) target.append_once(key, value);
      }
    }
  nodes.graphs()[kMergedGraph] = std::move(merged);
}

void unwrap_preserved(Json& framed) {
  if (!framed.is_structured() || is_value(framed)) return;
  for (Json& entry : framed) {
    const bool preserved = entry.is_object() && entry.contains("@preserve");
    if (preserved) {
      Json inner = entry["@preserve"].empty() ? Json("@null") : std::move(entry["@preserve"][0]);
      entry = std::move(inner);
    } else {
      unwrap_preserved(entry);
    }
  }
}

void prune_blank_nodes(Json& framed) {
  Counts counts;
  count_blank_nodes(framed, counts);
  drop_single_names(framed, counts);
}

void replace_nulls(Json& compacted) {
  if (compacted == "@null") compacted = nullptr;
  if (!compacted.is_structured()) return;
  if (compacted.is_array()) {
    Json kept = Json::array();
    for (Json& entry : compacted) {
      replace_nulls(entry);
      if (!entry.is_null()) kept.push_back(std::move(entry));
    }
    compacted = std::move(kept);
    return;
  }
  for (Json& entry : compacted) replace_nulls(entry);
}

Json compact(const Json& document, const Json& context, const Options& options) {
  Options plain = options;
  plain.keep_pointers = false;
  const Place place("compaction context#");
  return Compactor(plain, context, place).compact_document(expand(document, plain), false);
}

Json frame(const Json& document, const Json& frame, const Options& options, const FrameOptions& frame_options) {
  Options plain = options;
  plain.keep_pointers = false;
  const Json wanted = reading_frame([&] { return expanded_frame(frame, plain); });
  const bool merged = !reading_frame([&] { return asks_for_default_graph(frame, plain); });
  NodeMap nodes(expand(document, plain));
  if (merged) add_merged_graph(nodes);
  Json framed =
      reading_frame([&] { return Framer(nodes, merged ? kMergedGraph : kDefaultGraph, frame_options).frame(wanted); });
  nodes.graphs().clear();
  unwrap_preserved(framed);
  if (frame_options.prune_blank_nodes) prune_blank_nodes(framed);
  const Place place("frame#/@context");
  Json result = Compactor(plain, frame.value("@context", Json::object()), place)
                    .compact_document(framed, !frame_options.omit_graph);
  replace_nulls(result);
  return result;
}

}  // namespace opal::json_ld
