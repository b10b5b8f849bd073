#pragma once

#include "jsonld/framing/node_map.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace opal::json_ld {

/// How the nodes that match a frame are shown.
struct FrameFlags {
  std::string embed;
  bool explicit_values = false;
  bool require_all = false;
};

/// Counts what framing makes, so that a small frame cannot ask for more than memory holds.
class FrameBudget {
 public:
  explicit FrameBudget(std::size_t bytes) : left_(bytes) {}
  /// @throws JsonLdError "too much to embed".
  void spend(std::size_t bytes);
  /// For a value that is copied.
  void spend(const Json& value);

 private:
  std::size_t left_;
};

/// The frame that stands in an array of one. @throws JsonLdError "invalid frame".
const Json& single_frame(const Json& array);
/// The value of @embed, @explicit, ... in a frame; null if it does not say.
Json flag_of(const Json& frame, const char* keyword);
bool boolean_flag(const Json& frame, const char* keyword, bool otherwise);

/// Frame Matching (JSON-LD 1.1 Framing, 4.2.3).
class FrameMatcher {
 public:
  explicit FrameMatcher(const NodeGraph& graph) : graph_(graph) {}
  bool matches(const Json& node, const Json& frame, bool require_all) const;

 private:
  enum class Verdict { yes, no, skip, decides_no };
  Verdict match_id(const Json& node, const Json& pattern) const;
  Verdict match_type(const Json& node, const Json& pattern) const;
  Verdict match_property(const Json& values, const Json& pattern, bool require_all) const;
  bool match_list(const Json& values, const Json& pattern, bool require_all) const;
  bool match_reference(const Json& value, const Json& pattern, bool require_all) const;

  const NodeGraph& graph_;
};
/// Value Pattern Matching (4.2.4).
bool value_matches(const Json& value, const Json& pattern);

/// Framing Algorithm (4.2.2).
class Framer {
 public:
  /// @param graph  name of the graph whose nodes are framed; kMergedGraph: all graphs as one.
  Framer(NodeMap& nodes, std::string graph, const FrameOptions& options);
  /// @return an expanded document; what the frame wants to be null is the string "@null".
  Json frame(const Json& frame);

 private:
  using Ids = std::vector<std::string>;
  struct State {
    const std::string* graph;
    bool embedded;
    bool top = false;
  };
  /// A node that is being shown.
  struct Shown {
    const State& state;
    const Json& frame;
    const FrameFlags& flags;
    const Json& node;
    const std::string& id;
    const Ids& beside;  ///< the nodes among which it was found
    Json output;
  };

  FrameFlags flags_of(const Json& frame) const;
  /// The frame for what a frame with these flags does not mention.
  const Json& implied_frame(const FrameFlags& flags);
  void frame_nodes(const State& state, const Ids& ids, const Json& frame, Json& parent);
  void frame_node(const State& state, const Json& frame, const FrameFlags& flags, const Node& node, const Ids& beside,
                  Json& parent);
  void show(Shown& shown);
  void show_graph(Shown& shown);
  void show_included(Shown& shown);
  void show_properties(Shown& shown);
  void show_property(Shown& shown, const std::string& property, const Json& values);
  void show_list(Shown& shown, const Json& items, const Json& frame, Json& values);
  void show_defaults(Shown& shown) const;
  void show_reverse(Shown& shown);
  bool is_open(const State& state, const std::string& id) const;
  const Ids& referring(const std::string& graph, const std::string& property, const std::string& id);

  using Referring = std::unordered_map<std::string, Ids>;  // by the @id that is referred to

  std::map<std::string, NodeGraph>& graphs_;
  std::string graph_;
  const FrameOptions& options_;
  FrameBudget budget_;
  std::map<std::tuple<std::string, bool, bool>, Json> implied_;
  std::map<std::string, std::set<std::string>> embedded_;                // by graph
  std::vector<std::pair<const std::string*, const std::string*>> open_;  // graph and @id of nodes around
  std::map<std::pair<std::string, std::string>, Referring> referring_;   // by graph and property
};

inline constexpr const char* kMergedGraph = "@merged";
/// All graphs in one (JSON-LD 1.1 API, 7.2.2, Node Map Merging), as the graph kMergedGraph of the node map.
void add_merged_graph(NodeMap& nodes);

/// Every @preserve becomes what it preserves.
void unwrap_preserved(Json& framed);
/// Blank nodes that nothing else names lose their @id.
void prune_blank_nodes(Json& framed);
/// "@null" becomes null, and vanishes from arrays.
void replace_nulls(Json& compacted);

}  // namespace opal::json_ld
