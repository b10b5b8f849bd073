#pragma once

#include <opal/common/geometry.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <string_view>

/// The words of maps/context/opal.jsonld: full IRIs in documents, short names in memory and in messages.
namespace opal::vocabulary {

inline constexpr const char* kContextIri = "urn:opal:v1";
inline constexpr std::string_view kNamespace = "urn:opal:v1#";

namespace iri {
inline constexpr std::string_view kSemanticMap = "urn:opal:v1#SemanticMap";
inline constexpr std::string_view kSmear = "urn:opal:v1#smear_m";
inline constexpr std::string_view kCutHeight = "urn:opal:v1#cut_height_m";
inline constexpr std::string_view kStorey = "urn:opal:v1#storey";
inline constexpr std::string_view kWidestDoor = "urn:opal:v1#widest_door_m";
inline constexpr std::string_view kNorth = "urn:opal:v1#north_rad";
inline constexpr std::string_view kCrs = "urn:opal:v1#crs";
inline constexpr std::string_view kEastings = "urn:opal:v1#eastings_m";
inline constexpr std::string_view kNorthings = "urn:opal:v1#northings_m";
inline constexpr std::string_view kCrsHeight = "urn:opal:v1#crs_height_m";
inline constexpr std::string_view kCrsHeading = "urn:opal:v1#crs_heading_rad";
inline constexpr std::string_view kSourceClass = "urn:opal:v1#source_class";
inline constexpr std::string_view kThickness = "urn:opal:v1#thickness_m";
inline constexpr std::string_view kWidth = "urn:opal:v1#width_m";
inline constexpr std::string_view kAxis = "urn:opal:v1#axis";
inline constexpr std::string_view kMergedIds = "urn:opal:v1#merged_ids";
inline constexpr std::string_view kPlacement = "urn:opal:v1#MapPlacement";
inline constexpr std::string_view kScaleX = "urn:opal:v1#scale_x";
inline constexpr std::string_view kScaleY = "urn:opal:v1#scale_y";
inline constexpr std::string_view kBuilding = "https://w3id.org/bot#Building";
inline constexpr std::string_view kStoreyType = "https://w3id.org/bot#Storey";
inline constexpr std::string_view kHasStorey = "https://w3id.org/bot#hasStorey";
inline constexpr std::string_view kLevel = "urn:opal:v1#level_m";
inline constexpr std::string_view kConnection = "urn:opal:v1#StoreyConnection";
inline constexpr std::string_view kConnectionType = "urn:opal:v1#connection_type";
inline constexpr std::string_view kLandings = "urn:opal:v1#landings";
inline constexpr std::string_view kLanding = "urn:opal:v1#Landing";
inline constexpr std::string_view kOnStorey = "urn:opal:v1#on_storey";
inline constexpr std::string_view kName = "http://www.w3.org/2000/01/rdf-schema#label";
inline constexpr std::string_view kElement = "https://w3id.org/bot#Element";
inline constexpr std::string_view kGeoFeature = "http://www.opengis.net/ont/geosparql#Feature";
inline constexpr std::string_view kRepresentation = "urn:opal:v1#ObjectFeatureRepresentation";
inline constexpr std::string_view kRepresentedBy = "urn:opal:v1#represented_by";
inline constexpr std::string_view kHasGeometry = "http://www.opengis.net/ont/geosparql#hasGeometry";
inline constexpr std::string_view kPerceivableBy = "urn:opal:v1#perceivable_by";
inline constexpr std::string_view kFeatureType = "urn:opal:v1#feature_type";
inline constexpr std::string_view kPositionSigma = "urn:opal:v1#position_sigma_m";
inline constexpr std::string_view kExistence = "urn:opal:v1#existence";
inline constexpr std::string_view kSensor = "http://www.w3.org/ns/sosa/Sensor";
inline constexpr std::string_view kPoint = "http://www.opengis.net/ont/sf#Point";
inline constexpr std::string_view kLineSegment = "http://www.opengis.net/ont/sf#Line";
inline constexpr std::string_view kCorner = "urn:opal:v1#Corner";
inline constexpr std::string_view kCircle = "urn:opal:v1#Circle";
inline constexpr std::string_view kX = "urn:opal:v1#x";
inline constexpr std::string_view kY = "urn:opal:v1#y";
inline constexpr std::string_view kBegin = "urn:opal:v1#begin";
inline constexpr std::string_view kEnd = "urn:opal:v1#end";
inline constexpr std::string_view kCornerPoint = "urn:opal:v1#point";
inline constexpr std::string_view kHeading = "urn:opal:v1#heading_rad";
inline constexpr std::string_view kOpening = "urn:opal:v1#opening_rad";
inline constexpr std::string_view kCenter = "urn:opal:v1#center";
inline constexpr std::string_view kRadius = "urn:opal:v1#radius_m";
inline constexpr std::string_view kPattern = "urn:opal:v1#FeaturePattern";
inline constexpr std::string_view kTemplate = "urn:opal:v1#template";
inline constexpr std::string_view kFeatures = "urn:opal:v1#features";
inline constexpr std::string_view kSubpatterns = "urn:opal:v1#subpatterns";
inline constexpr std::string_view kDimensions = "urn:opal:v1#dimensions";
inline constexpr std::string_view kOverlay = "urn:opal:v1#MapOverlay";
inline constexpr std::string_view kChanges = "urn:opal:v1#changes";
inline constexpr std::string_view kChange = "urn:opal:v1#MapChange";
inline constexpr std::string_view kTarget = "urn:opal:v1#target";
inline constexpr std::string_view kNotPerceivableBy = "urn:opal:v1#not_perceivable_by";
inline constexpr std::string_view kObjectType = "urn:opal:v1#object_type";
inline constexpr std::string_view kBecause = "urn:opal:v1#because";
inline constexpr std::string_view kWas = "urn:opal:v1#was";
inline constexpr std::string_view kIfMissing = "urn:opal:v1#if_missing";
}  // namespace iri

extern const char* const kContextText;  ///< of maps/context/opal.jsonld, built in
OPAL_EXPORT const nlohmann::json& context_document();

/// Prefixes of names, and the IRIs that they stand for.
using Prefixes = std::map<std::string, std::string>;

/// "urn:opal:v1#Wall" -> "opal:Wall", for the prefixes of Opal's context and then for others; other names stay as
/// they are. Of several that fit, the prefix of the longest IRI is taken.
std::string compact_name(const std::string& name, const Prefixes& others = {});
/// "opal:Wall" and "Wall" -> "urn:opal:v1#Wall"; other names stay as they are.
std::string full_iri(const std::string& name);
/// "acme" of "acme:Kiosk"; empty for names whose beginning is no prefix: "https://acme.example/Kiosk", "urn:kiosk".
std::string prefix_of(const std::string& name);
/// What a word should be that is no IRI, as the end of a message: the prefix is not defined, or it has none.
std::string expected_iri(const std::string& word);
/// True for the terms, and for the prefixes, that Opal's context defines.
bool is_term(const std::string& word);
bool is_prefix(const std::string& word);
/// The IRI that a prefix stands for if nobody says: names must be IRIs in a document.
std::string iri_of_nameless_prefix(const std::string& prefix);
/// The shortest way to write a name in a document: "opal:Wall" -> "Wall", "sf:Line" -> "LineSegment".
std::string short_term(std::string_view name);
/// True for IRIs of Opal's own namespace that the context defines.
bool is_own_term(const std::string& iri);
inline bool is_own(std::string_view iri) { return iri.starts_with(kNamespace); }
/// Types by which the reader tells what a node is: no thing in a building can have them.
bool is_reserved_type(std::string_view iri);
/// Types that shapes have. An object may have such a type too ("opal:Corner").
bool is_geometry_type(std::string_view iri);
/// Types that make a node an object, even one that nothing represents: bot:Element and Opal's own types.
bool is_object_type(std::string_view iri);
inline bool is_blank(std::string_view id) { return id.starts_with("_:"); }

/// What a detector must produce to see a geometry, if the map does not say otherwise.
std::string default_feature_type(const Geometry& geometry);

}  // namespace opal::vocabulary
