// The key functions of the interfaces: one vtable and one typeinfo each, in libopal.so.
#include <opal/map/map_importer.hpp>
#include <opal/map/map_store.hpp>

namespace opal {

MapImporter::~MapImporter() = default;
std::vector<Storey> MapImporter::storeys(const std::string&) const { return {}; }
MapStore::~MapStore() = default;
StoreError::~StoreError() = default;
StoreUnreachable::~StoreUnreachable() = default;
StoreConflict::~StoreConflict() = default;

}  // namespace opal
