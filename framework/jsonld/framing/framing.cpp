// JSON-LD 1.1 Framing, 4.2.2: Framing Algorithm. Numbers in comments are steps of that section.
#include "jsonld/framing/framing.hpp"

#include "jsonld/context/iri.hpp"

#include <algorithm>

namespace opal::json_ld {
namespace {

constexpr std::size_t kMaxOpen = 128;    // nodes inside each other: bounds every recursion over the result
constexpr std::size_t kNodeBytes = 128;  // what a node costs, its text apart
constexpr std::size_t kMatchBytes = 8;   // what looking at a node costs, in terms of what making one does

const Json kNothing = Json::object();

[[noreturn]] void refuse_frame(const std::string& found) { throw JsonLdError("invalid frame", "frame", found); }

void check_names(const Json& frame, const char* keyword) {
  const auto names = frame.find(keyword);
  if (names == frame.end()) return;
  for (const Json& name : *names)
    if (name.is_null() || (name.is_string() && is_blank_node(name.get<std::string>())))
      refuse_frame(name.dump() + " for " + keyword + ", expected IRIs");
}

}  // namespace

void FrameBudget::spend(std::size_t bytes) {
  if (bytes > left_)
    throw JsonLdError("too much to embed", "frame",
                      "the result would be larger than allowed; expected a narrower frame, or @embed: @once");
  left_ -= bytes;
}

void FrameBudget::spend(const Json& value) {
  const auto size_of = [](const auto& self, const Json& part) -> std::size_t {
    std::size_t size = kNodeBytes / 4;
    if (part.is_string()) size += part.get_ref<const std::string&>().size();
    if (part.is_structured())
      for (const auto& [key, entry] : part.items()) size += key.size() + self(self, entry);
    return size;
  };
  spend(size_of(size_of, value));
}

const Json& single_frame(const Json& array) {
  if (!array.is_array() || array.size() != 1 || !array[0].is_object())
    refuse_frame("found " + array.dump().substr(0, 80) + ", expected one object");
  const Json& frame = array[0];
  check_names(frame, "@id");
  if (!is_value(frame)) check_names(frame, "@type");
  return frame;
}

Json flag_of(const Json& frame, const char* keyword) {
  const auto flag = frame.find(keyword);
  return flag == frame.end() ? Json() : flag->at(0).at("@value");
}

bool boolean_flag(const Json& frame, const char* keyword, bool otherwise) {
  const Json flag = flag_of(frame, keyword);
  if (flag.is_null()) return otherwise;
  if (flag == "true" || flag == "false") return flag == "true";  // so written by many, the W3C's tests among them
  if (!flag.is_boolean()) refuse_frame(flag.dump() + " for " + keyword + ", expected true or false");
  return flag.get<bool>();
}

Framer::Framer(NodeMap& nodes, std::string graph, const FrameOptions& options)
    : graphs_(nodes.graphs()), graph_(std::move(graph)), options_(options), budget_(options.bytes) {}

Json Framer::frame(const Json& frame) {
  Ids ids;
  for (const auto& [id, node] : graphs_[graph_]) ids.push_back(id);
  Json framed = Json::array();
  frame_nodes({&graph_, false, true}, ids, frame, framed);
  return framed;
}

FrameFlags Framer::flags_of(const Json& frame) const {  // 2
  FrameFlags flags{options_.embed, boolean_flag(frame, "@explicit", options_.explicit_values),
                   boolean_flag(frame, "@requireAll", options_.require_all)};
  const Json embed = flag_of(frame, "@embed");
  if (embed.is_boolean()) flags.embed = embed.get<bool>() ? "@once" : "@never";
  if (embed.is_string()) flags.embed = embed.get<std::string>();
  if (flags.embed != "@once" && flags.embed != "@always" && flags.embed != "@never")
    throw JsonLdError("invalid @embed value", "frame", "\"" + flags.embed + "\", expected @once, @always or @never");
  return flags;
}

const Json& Framer::implied_frame(const FrameFlags& flags) {
  Json& frame = implied_[{flags.embed, flags.explicit_values, flags.require_all}];
  if (!frame.is_null()) return frame;
  const auto flag = [](const Json& value) { return Json::array({Json{{"@value", value}}}); };
  frame = {{"@embed", flag(flags.embed)},
           {"@explicit", flag(flags.explicit_values)},
           {"@requireAll", flag(flags.require_all)}};
  return frame;
}

void Framer::frame_nodes(const State& state, const Ids& ids, const Json& frame, Json& parent) {
  const FrameFlags flags = flags_of(frame);
  const NodeGraph& graph = graphs_.at(*state.graph);
  const FrameMatcher matcher(graph);
  for (const std::string& id : ids) {
    budget_.spend(kMatchBytes);
    const auto node = graph.find(id);
    if (node == graph.end() || !matcher.matches(node->second.json(), frame, flags.require_all)) continue;
    if (state.top) embedded_.clear();
    frame_node(state, frame, flags, node->second, ids, parent);
  }
}

/// 4.1 to 4.4: the node itself, or its @id if it stands elsewhere.
void Framer::frame_node(const State& state, const Json& frame, const FrameFlags& flags, const Node& node,
                        const Ids& beside, Json& parent) {
  std::set<std::string>& embedded = embedded_[*state.graph];
  const bool known = embedded.count(node.id()) > 0;
  if (!state.embedded && known) return;
  budget_.spend(kNodeBytes + node.id().size());
  Shown shown{state, frame, flags, node.json(), node.id(), beside, Json{{"@id", node.id()}}};
  const bool only_named = flags.embed == "@never" || is_open(state, node.id()) || (flags.embed == "@once" && known);
  if (!state.embedded || !only_named) {
    embedded.insert(node.id());
    show(shown);
  }
  parent.push_back(std::move(shown.output));
}

bool Framer::is_open(const State& state, const std::string& id) const {
  return std::any_of(open_.begin(), open_.end(),
                     [&](const auto& open) { return *open.first == *state.graph && *open.second == id; });
}

void Framer::show(Shown& shown) {
  open_.emplace_back(shown.state.graph, &shown.id);
  if (open_.size() > kMaxOpen)
    throw JsonLdError("nested too deeply", "frame",
                      "more than " + std::to_string(kMaxOpen) + " nodes inside each other, the last one <" + shown.id +
                          ">; expected a frame with @embed: @never");
  show_graph(shown);
  if (shown.frame.contains("@included")) show_included(shown);
  show_properties(shown);
  show_defaults(shown);
  if (shown.frame.contains("@reverse")) show_reverse(shown);
  open_.pop_back();
}

void Framer::show_graph(Shown& shown) {  // 4.5
  const auto graph = graphs_.find(shown.id);
  if (graph == graphs_.end()) return;
  const auto wanted = shown.frame.find("@graph");
  const bool named = wanted != shown.frame.end();
  if (named ? shown.id == kMergedGraph || shown.id == kDefaultGraph : *shown.state.graph == kMergedGraph) return;
  Ids ids;
  for (const auto& [id, node] : graph->second) ids.push_back(id);
  const bool framed = named && !wanted->empty() && wanted->at(0).is_object();
  Json nodes = Json::array();
  frame_nodes({&graph->first, false}, ids, framed ? wanted->at(0) : kNothing, nodes);
  if (!nodes.empty()) shown.output["@graph"] = std::move(nodes);
}

void Framer::show_included(Shown& shown) {  // 4.6
  Json nodes = Json::array();
  for (const Json& frame : shown.frame["@included"])
    frame_nodes({shown.state.graph, false}, shown.beside, frame, nodes);
  if (!nodes.empty()) shown.output["@included"] = std::move(nodes);
}

void Framer::show_properties(Shown& shown) {  // 4.7
  for (const auto& [property, values] : shown.node.items()) {
    if (is_keyword(property)) {
      budget_.spend(values);
      shown.output[property] = values;
    } else if (!shown.flags.explicit_values || shown.frame.contains(property)) {
      show_property(shown, property, values);
    }
  }
}

void Framer::show_property(Shown& shown, const std::string& property, const Json& values) {
  const auto wanted = shown.frame.find(property);
  const bool named = wanted != shown.frame.end();
  if (named && wanted->empty()) return;  // []: none of them
  const Json& frame = named ? single_frame(*wanted) : implied_frame(shown.flags);
  const State inside{shown.state.graph, true};
  Json output = Json::array();
  for (const Json& value : values) {
    if (is_list(value)) {
      show_list(shown, value["@list"], frame, output);
    } else if (is_reference(value)) {
      frame_nodes(inside, {value["@id"].get<std::string>()}, frame, output);
    } else if (value_matches(value, frame)) {
      budget_.spend(value);
      output.push_back(value);
    }
  }
  if (!output.empty() || values.empty()) shown.output[property] = std::move(output);
}

void Framer::show_list(Shown& shown, const Json& items, const Json& frame, Json& values) {  // 4.7.3.1
  const bool named = is_list(frame) && !frame["@list"].empty();
  const Json& inner = named ? single_frame(frame["@list"]) : implied_frame(shown.flags);
  const State inside{shown.state.graph, true};
  Json shown_items = Json::array();
  for (const Json& item : items) {
    if (is_reference(item)) {
      frame_nodes(inside, {item["@id"].get<std::string>()}, inner, shown_items);
    } else {
      budget_.spend(item);
      shown_items.push_back(item);
    }
  }
  values.push_back(Json{{"@list", std::move(shown_items)}});
}

void Framer::show_defaults(Shown& shown) const {  // 4.7.4
  for (const auto& [property, patterns] : shown.frame.items()) {
    const Json& frame = patterns.is_array() && !patterns.empty() ? patterns[0] : kNothing;
    const bool keyword = is_keyword(property) || is_framing_keyword(property);
    if (keyword && (property != "@type" || !frame.is_object() || !frame.contains("@default"))) continue;
    if (shown.output.contains(property) || boolean_flag(frame, "@omitDefault", options_.omit_default)) continue;
    Json value = Json::array({"@null"});
    if (frame.contains("@default")) value = frame["@default"];
    shown.output[property] = Json::array({Json{{"@preserve", std::move(value)}}});
  }
}

void Framer::show_reverse(Shown& shown) {  // 4.7.5
  const State inside{shown.state.graph, true};
  for (const auto& [property, frame] : shown.frame["@reverse"].items()) {
    if (property == kPointer) continue;
    const Ids& ids = referring(*shown.state.graph, property, shown.id);
    if (ids.empty()) continue;
    Json nodes = Json::array();
    frame_nodes(inside, ids, single_frame(frame), nodes);
    shown.output["@reverse"][property] = std::move(nodes);
  }
}

const Framer::Ids& Framer::referring(const std::string& graph, const std::string& property, const std::string& id) {
  const auto [entry, fresh] = referring_.try_emplace({graph, property});
  Referring& referring = entry->second;
  if (fresh)
    for (const auto& [from, node] : graphs_.at(graph)) {
      const auto values = node.json().find(property);
      if (values == node.json().end()) continue;
      std::set<std::string> targets;
      for (const Json& value : *values)
        if (is_reference(value)) targets.insert(value["@id"].get<std::string>());
      for (const std::string& target : targets) referring[target].push_back(from);
    }
  static const Ids none;
  const auto found = referring.find(id);
  return found == referring.end() ? none : found->second;
}

}  // namespace opal::json_ld
