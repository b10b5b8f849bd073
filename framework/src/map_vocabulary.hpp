#pragma once

#include <opal/geometry.hpp>

#include <nlohmann/json.hpp>

#include <string>

/// The words of maps/context/opal.jsonld: full IRIs in documents, short names in memory and in messages.
namespace opal::vocabulary {

inline constexpr const char* kContextIri = "urn:opal:v1";
inline constexpr const char* kNamespace = "urn:opal:v1#";

namespace iri {
inline constexpr const char* kSemanticMap = "urn:opal:v1#SemanticMap";
inline constexpr const char* kName = "http://www.w3.org/2000/01/rdf-schema#label";
inline constexpr const char* kElement = "https://w3id.org/bot#Element";
inline constexpr const char* kGeoFeature = "http://www.opengis.net/ont/geosparql#Feature";
inline constexpr const char* kRepresentation = "urn:opal:v1#ObjectFeatureRepresentation";
inline constexpr const char* kRepresentedBy = "urn:opal:v1#represented_by";
inline constexpr const char* kHasGeometry = "http://www.opengis.net/ont/geosparql#hasGeometry";
inline constexpr const char* kPerceivableBy = "urn:opal:v1#perceivable_by";
inline constexpr const char* kFeatureType = "urn:opal:v1#feature_type";
inline constexpr const char* kPositionSigma = "urn:opal:v1#position_sigma_m";
inline constexpr const char* kExistence = "urn:opal:v1#existence";
inline constexpr const char* kSensor = "http://www.w3.org/ns/sosa/Sensor";
inline constexpr const char* kPoint = "http://www.opengis.net/ont/sf#Point";
inline constexpr const char* kLineSegment = "http://www.opengis.net/ont/sf#Line";
inline constexpr const char* kCorner = "urn:opal:v1#Corner";
inline constexpr const char* kCircle = "urn:opal:v1#Circle";
inline constexpr const char* kX = "urn:opal:v1#x";
inline constexpr const char* kY = "urn:opal:v1#y";
inline constexpr const char* kBegin = "urn:opal:v1#begin";
inline constexpr const char* kEnd = "urn:opal:v1#end";
inline constexpr const char* kCornerPoint = "urn:opal:v1#point";
inline constexpr const char* kHeading = "urn:opal:v1#heading_rad";
inline constexpr const char* kOpening = "urn:opal:v1#opening_rad";
inline constexpr const char* kCenter = "urn:opal:v1#center";
inline constexpr const char* kRadius = "urn:opal:v1#radius_m";
inline constexpr const char* kPattern = "urn:opal:v1#FeaturePattern";
inline constexpr const char* kTemplate = "urn:opal:v1#template";
inline constexpr const char* kFeatures = "urn:opal:v1#features";
inline constexpr const char* kSubpatterns = "urn:opal:v1#subpatterns";
inline constexpr const char* kDimensions = "urn:opal:v1#dimensions";
}  // namespace iri

extern const char* const kContextText;  ///< of maps/context/opal.jsonld, built in
const nlohmann::json& context_document();

/// "urn:opal:v1#Wall" -> "opal:Wall", for the prefixes of the context; other names stay as they are.
std::string compact_name(const std::string& name);
/// "opal:Wall" and "Wall" -> "urn:opal:v1#Wall"; other names stay as they are.
std::string full_iri(const std::string& name);
/// The shortest way to write a name in a document: "opal:Wall" -> "Wall", "sf:Line" -> "LineSegment".
std::string short_term(const std::string& name);
/// True for IRIs of Opal's own namespace that the context defines.
bool is_own_term(const std::string& iri);
inline bool is_own(const std::string& iri) { return iri.starts_with(kNamespace); }
/// Types by which the reader tells what a node is: no thing in a building can have them.
bool is_reserved_type(const std::string& iri);
/// Types that shapes have. An object may have such a type too ("opal:Corner").
bool is_geometry_type(const std::string& iri);
/// Types that make a node an object, even one that nothing represents: bot:Element and Opal's own types.
bool is_object_type(const std::string& iri);
inline bool is_blank(const std::string& id) { return id.starts_with("_:"); }

/// What a detector must produce to see a geometry, if the map does not say otherwise.
std::string default_feature_type(const Geometry& geometry);

}  // namespace opal::vocabulary
