#pragma once

#include <opal/deployment/deployment.hpp>

#include <string>

namespace opal {

inline const std::string kFile = "configs/hall.jsonld";

/// A deployment with these members beside the ones that it cannot be without.
inline std::string document(const std::string& members) {
  return R"({"@context": "urn:opal:v1", "@type": "opal:Deployment")" +
         std::string(members.find("\"scorers\"") == std::string::npos ? R"(, "scorers": [{"@type": "opal:Beams"}])"
                                                                      : "") +
         (members.empty() ? "" : ", " + members) + "}";
}

inline Deployment parsed(const std::string& members) { return parse_deployment(document(members), kFile); }

}  // namespace opal
