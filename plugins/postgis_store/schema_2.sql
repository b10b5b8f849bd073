-- The map store's tables, version 2: what drives say of a map. Robots add rows, and need no other right to write.
CREATE TABLE opal.drive_evidence (
  map      bigint NOT NULL REFERENCES opal.map_versions ON DELETE CASCADE,
  digest   text NOT NULL,                   -- SHA-256 of the document as it came: what comes twice counts once
  added_at timestamptz NOT NULL DEFAULT now(),
  added_by text NOT NULL DEFAULT session_user,
  document jsonb NOT NULL,                  -- a drive, as opal learn --evidence writes it
  PRIMARY KEY (map, digest)
);
