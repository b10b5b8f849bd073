#pragma once

#include <opal/common/error.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <string>

namespace opal::json_ld {

/// A document that breaks JSON-LD 1.1.
class OPAL_EXPORT JsonLdError : public MapError {
 public:
  /// @param code     W3C error code, e.g. "invalid term definition". Of our own are "nested too deeply", "colliding
  /// containers" and,
  ///                 for Options::reject_unknown_terms, "unknown term", "unknown prefix", "unknown keyword",
  ///                 "misplaced keyword" and "free-floating value".
  /// @param pointer  JSON pointer into the source document, "" for the whole; inside a context that was named
  ///                 by IRI "IRI#POINTER".
  JsonLdError(std::string code, std::string pointer, const std::string& detail);
  ~JsonLdError() override;
  const std::string& code() const { return code_; }
  const std::string& pointer() const { return pointer_; }

 private:
  std::string code_;
  std::string pointer_;
};

struct Options {
  std::string base;  ///< IRI that relative references resolve against; empty: they stay relative
  /// Contexts that may be named by IRI; nothing is ever fetched.
  std::map<std::string, nlohmann::json> contexts;
  /// Taken in before the document's own context, as if it came first; null: none.
  nlohmann::json expand_context = nullptr;
  /// Keep, in every node and value object, where it came from: "@pointer": "/objects/3/geometry". Not
  /// JSON-LD; for error messages of the caller. Flattening keeps the place that defines a node rather than
  /// one that refers to it, and of several equal ones the first; references keep their own.
  bool keep_pointers = false;
  /// Refuse what JSON-LD drops silently or misreads: keys, types and @vocab-typed values that map to no IRI
  /// or have a prefix that is not defined ("opl:Wall"; "http://..." and "urn:..." are whole IRIs), words that
  /// look like keywords, and values where only nodes count. A term that the context maps to null is still
  /// dropped: that is its purpose.
  bool reject_unknown_terms = false;
  /// Reject prefixed names whose prefix no context defines (JSON-LD takes them for absolute IRIs).
  bool reject_unknown_prefixes = false;
  /// Compaction: an array with one value becomes that value, where the context does not ask for an array.
  bool compact_arrays = true;
};

/// W3C JSON-LD 1.1 API, Expansion Algorithm (5.1.2), processing mode json-ld-1.1, every part of it. Arrays
/// keep the order of the document, entries are visited in the order of their keys. @throws JsonLdError.
OPAL_EXPORT nlohmann::json expand(const nlohmann::json& document, const Options& options = {});

/// W3C JSON-LD 1.1 API, Flattening (7.2) of the expanded document: an array of node objects by @id, without
/// compaction. Blank nodes are labelled _:b0, _:b1, ... the same way for the same document. @throws
/// JsonLdError.
OPAL_EXPORT nlohmann::json flatten(const nlohmann::json& document, const Options& options = {});

/// W3C JSON-LD 1.1 API, Compaction Algorithm (6.1.2) of the expanded document.
/// @param context  the value of a @context, or an object that has one. @throws JsonLdError.
OPAL_EXPORT nlohmann::json compact(const nlohmann::json& document, const nlohmann::json& context,
                                   const Options& options = {});

/// What holds where a frame does not say. JSON-LD 1.1 Framing, 5.2.
struct FrameOptions {
  std::string embed = "@once";     ///< @once, @always or @never
  bool explicit_values = false;    ///< leave out properties that the frame does not name
  bool require_all = false;        ///< a node must match all that the frame asks for, not one of it
  bool omit_default = false;       ///< leave out what the frame names and the node lacks, instead of null
  bool omit_graph = true;          ///< a single node stands for itself, outside of @graph
  bool prune_blank_nodes = true;   ///< no @id for blank nodes that nothing refers to
  std::size_t bytes = 128u << 20;  ///< the result is no larger than about this, and its work no longer than that takes
};

/// W3C JSON-LD 1.1 Framing (4.1): the nodes of the document that match the frame, as trees of the frame's shape,
/// compacted with its context. Matches come in order of @id, the properties of a node in order of their IRIs.
/// @throws JsonLdError; of our own are the codes "too much to embed", for a result beyond `FrameOptions::bytes`, and
/// "nested too deeply", for more than 128 nodes inside each other.
OPAL_EXPORT nlohmann::json frame(const nlohmann::json& document, const nlohmann::json& frame,
                                 const Options& options = {}, const FrameOptions& frame_options = {});

}  // namespace opal::json_ld
