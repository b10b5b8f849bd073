-- The map store's tables, version 1; docs/map_store.md explains them. All lengths are metres in the frame `map` of the
-- building, which is no geographic one: SRID 0.
CREATE EXTENSION IF NOT EXISTS postgis;
CREATE EXTENSION IF NOT EXISTS btree_gist;
CREATE SCHEMA opal;

CREATE TABLE opal.schema_version (
  version    integer PRIMARY KEY,
  applied_at timestamptz NOT NULL DEFAULT now()
);

CREATE TABLE opal.buildings (
  id     bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  name   text NOT NULL UNIQUE CHECK (name <> ''),
  newest integer NOT NULL DEFAULT 0  -- number of the newest version; numbers are never given twice
);

-- One row per push. Nothing below a version changes once it is there.
CREATE TABLE opal.map_versions (
  id                bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  building          bigint NOT NULL REFERENCES opal.buildings ON DELETE CASCADE,
  version           integer NOT NULL CHECK (version > 0),
  pushed_at         timestamptz NOT NULL DEFAULT now(),
  pushed_by         text NOT NULL DEFAULT session_user,
  message           text NOT NULL,
  map_name          text NOT NULL,
  context           jsonb NOT NULL,             -- the document's @context
  objects           integer NOT NULL,
  features          integer NOT NULL,
  patterns          integer NOT NULL,
  largest_radius_m  double precision NOT NULL,  -- of the circles: how far a rim may be from its centre
  UNIQUE (building, version)
);

-- The JSON-LD graph, flat: one row per node, in the words of its context. @context and the nodes are the whole map.
CREATE TABLE opal.nodes (
  map      bigint NOT NULL REFERENCES opal.map_versions ON DELETE CASCADE,
  position integer NOT NULL,
  id       text NOT NULL,
  types    text[] NOT NULL,
  node     jsonb NOT NULL,
  PRIMARY KEY (map, position)
);
CREATE INDEX ON opal.nodes (map, id);

-- The edges of that graph, for joins: "subject" has "object" as its "relation" number "position".
CREATE TABLE opal.node_relations (
  map      bigint NOT NULL REFERENCES opal.map_versions ON DELETE CASCADE,
  subject  text NOT NULL,
  relation text NOT NULL,
  position integer NOT NULL,
  object   text NOT NULL
);
CREATE INDEX ON opal.node_relations (map, subject, relation);
CREATE INDEX ON opal.node_relations (map, object, relation);

-- The same features once more, one flat row each, for spatial questions. The sensor is a column: as a node of the graph
-- it is tied to everything, which leads a planner astray.
CREATE TABLE opal.features (
  map              bigint NOT NULL REFERENCES opal.map_versions ON DELETE CASCADE,
  number           integer NOT NULL,            -- position among the features of the map
  id               text NOT NULL,               -- of the geometry's node
  sensor           text NOT NULL,               -- that perceives it; empty: none does
  type             text NOT NULL,               -- what a detector must produce to see it: opal:Wall
  object           text NOT NULL,               -- id of the object's node
  object_type      text NOT NULL,
  representation   text NOT NULL,               -- id of its ObjectFeatureRepresentation; empty: it has no name
  shape            text NOT NULL CHECK (shape IN ('point', 'corner', 'segment', 'circle')),
  geom             geometry(Geometry, 0) NOT NULL,  -- a corner's point, a circle's centre
  radius_m         double precision NOT NULL,   -- of a circle, otherwise 0
  heading_rad      double precision,            -- of a corner
  opening_rad      double precision,            -- of a corner
  position_sigma_m double precision NOT NULL,
  existence        double precision NOT NULL,
  PRIMARY KEY (map, number)
);
CREATE INDEX ON opal.features USING gist (map, geom);

CREATE VIEW opal.versions AS
  SELECT b.name AS building, v.version, v.version = b.newest AS is_newest, v.id AS map, v.pushed_at, v.pushed_by, v.message,
         v.map_name, v.objects, v.features, v.patterns
  FROM opal.buildings b JOIN opal.map_versions v ON v.building = b.id;

-- Which features can a sensor perceive within radius_m of (x, y)? A circle is its rim. Version 0: the newest.
CREATE FUNCTION opal.features_near(of_building text, of_version integer, of_sensor text, x double precision,
                                   y double precision, within_m double precision)
RETURNS TABLE (number integer, id text, type text, object text, object_type text, geom geometry, radius_m double precision,
               distance_m double precision)
LANGUAGE sql STABLE AS $$
  SELECT f.number, f.id, f.type, f.object, f.object_type, f.geom, f.radius_m, d.distance_m
  FROM opal.buildings b
  JOIN opal.map_versions v ON v.building = b.id AND v.version = CASE of_version WHEN 0 THEN b.newest ELSE of_version END
  JOIN opal.features f ON f.map = v.id
  CROSS JOIN LATERAL (
    SELECT CASE f.shape WHEN 'circle' THEN abs(ST_Distance(f.geom, ST_MakePoint(x, y)) - f.radius_m)
                        ELSE ST_Distance(f.geom, ST_MakePoint(x, y)) END AS distance_m) d
  WHERE b.name = of_building AND f.sensor = of_sensor
    AND f.geom && ST_Expand(ST_MakePoint(x, y), within_m + v.largest_radius_m)
    AND d.distance_m <= within_m
  ORDER BY f.number
$$;
