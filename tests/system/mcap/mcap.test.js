// MCAP files of another implementation read by Opal, and files of Opal read by the other one.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { McapIndexedReader, McapStreamReader, McapWriter, TempBuffer } from "@mcap/core";
import unpackLz4 from "@foxglove/wasm-lz4";
import zstd from "@foxglove/wasm-zstd";
import lz4 from "lz4js";

import { laserScan, odometry } from "./messages.js";

const folder = mkdtempSync(join(tmpdir(), "opal_mcap_"));
const recorded = new URL("../../../../shared/data/ros2/gazebo_path.mcap", import.meta.url).pathname;
const decompressHandlers = {
  lz4: (bytes, size) => unpackLz4(bytes, Number(size)),
  zstd: (bytes, size) => zstd.decompress(bytes, Number(size)),
};
const packers = {
  none: undefined,
  lz4: (bytes) => ({ compression: "lz4", compressedData: new Uint8Array(lz4.compress(bytes)) }),
  zstd: (bytes) => ({ compression: "zstd", compressedData: zstd.compress(bytes) }),
};

before(async () => {
  await unpackLz4.isLoaded;
  await zstd.isLoaded;
});
after(() => rmSync(folder, { recursive: true }));

/** 200 scans at 10 Hz and as many poses, in chunks of 10 kB. @return the path of the file */
async function writeDrive(name, options, profile = "ros2") {
  const buffer = new TempBuffer();
  const writer = new McapWriter({ writable: buffer, chunkSize: 10000, ...options });
  await writer.start({ profile, library: "test" });
  const channel = async (topic, type) => {
    const schemaId = await writer.registerSchema({ name: type, encoding: "ros2msg", data: new Uint8Array() });
    return writer.registerChannel({ topic, schemaId, messageEncoding: "cdr", metadata: new Map() });
  };
  const scan = await channel("/scan", "sensor_msgs/msg/LaserScan");
  const odom = await channel("/odom", "nav_msgs/msg/Odometry");
  for (let i = 0; i < 200; ++i) {
    const stamp_s = 1000 + i / 10;
    const logTime = BigInt(Math.round(stamp_s * 1e9));
    const message = (channelId, data) => writer.addMessage({ channelId, sequence: i, logTime, publishTime: logTime, data });
    await message(odom, odometry(stamp_s, 0.05 * i));
    await message(scan, laserScan(stamp_s, Array.from({ length: 100 }, (_, k) => 1 + ((k * 7 + i) % 50) / 10)));
  }
  await writer.addAttachment({ name: "note", mediaType: "text/plain", data: new Uint8Array([1, 2, 3]), logTime: 0n, createTime: 0n });
  await writer.addMetadata({ name: "robot", metadata: new Map([["name", "one"]]) });
  await writer.end();
  const path = join(folder, name);
  writeFileSync(path, buffer.get());
  return path;
}

function opalInfo(path) {
  return JSON.parse(execFileSync(process.env.OPAL_PROGRAM, ["info", path, "--json"], { encoding: "utf8" }));
}

const layouts = {
  "chunks with all indices": {},
  "chunks without message indices": { useMessageIndex: false },
  "chunks without any summary": {
    useMessageIndex: false, useChunkIndex: false, useStatistics: false, useSummaryOffsets: false,
    repeatSchemas: false, repeatChannels: false, useAttachmentIndex: false, useMetadataIndex: false,
  },
  "message indices without a summary": {
    useChunkIndex: false, useStatistics: false, useSummaryOffsets: false, repeatSchemas: false, repeatChannels: false,
  },
  "no chunks": { useChunks: false },
};

for (const [layout, options] of Object.entries(layouts))
  for (const [packing, compressChunk] of Object.entries(packers))
    test(`opal reads a file with ${layout}, packed with ${packing}`, async () => {
      const path = await writeDrive(`${layout} ${packing}.mcap`.replaceAll(" ", "_"), { ...options, compressChunk });
      const info = opalInfo(path);
      assert.deepEqual(info.topics.map((topic) => [topic.name, topic.messages]), [["/odom", 200], ["/scan", 200]]);
      const [laser] = info.lasers;
      assert.deepEqual([laser.scans, laser.beams, laser.is_read], [200, 100, true]);
      assert.ok(Math.abs(info.odometries[0].driven_m - 199 * 0.05) < 1e-6);
      assert.deepEqual(Object.keys(info.defects), []);
    });

test("opal tells what of a cut file is left", async () => {
  const whole = readFileSync(await writeDrive("whole.mcap", { compressChunk: packers.zstd }));
  let most = 0;
  for (const share of [0.1, 0.3, 0.5, 0.7, 0.9]) {
    const path = join(folder, "cut.mcap");
    writeFileSync(path, whole.subarray(0, Math.floor(share * whole.length)));
    const info = opalInfo(path);
    assert.ok(info.topics[1].messages > most, `${share}: ${info.topics[1].messages} after ${most}`);
    most = info.topics[1].messages;
    assert.match(Object.keys(info.defects).join(), /the file ends at byte \d+/);
  }
});

async function readIndexed(bytes) {
  const readable = { size: async () => BigInt(bytes.length), read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)) };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const messages = [];
  for await (const message of reader.readMessages({ validateCrcs: true }))
    messages.push([reader.channelsById.get(message.channelId).topic, new TextDecoder().decode(message.data)]);
  return { reader, messages };
}

function readStreamed(bytes) {
  const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  stream.append(bytes);
  const records = [];
  for (let record; (record = stream.nextRecord()); ) records.push(record);
  assert.ok(stream.done());
  return records;
}

for (const packing of ["none", "lz4", "zstd"])
  test(`the other implementation reads a file of Opal packed with ${packing}, by index and as a stream`, async () => {
    const path = join(folder, `opal_${packing}.mcap`);
    execFileSync(process.env.OPAL_MCAP_SAMPLE, [path, packing === "none" ? "" : packing]);
    const bytes = readFileSync(path);
    const { reader, messages } = await readIndexed(bytes);
    assert.equal(messages.length, 1000);
    assert.deepEqual(messages[0], ["/a", "message 0"]);
    assert.deepEqual(messages[999], ["/b", "message 999"]);
    assert.ok(reader.chunkIndexes.length > 5);
    assert.equal(reader.statistics.messageCount, 1000n);
    assert.deepEqual([...reader.statistics.channelMessageCounts.values()], [500n, 500n]);
    assert.equal(reader.header.profile, "ros2");
    assert.equal([...reader.channelsById.values()][0].metadata.get("offered_qos_profiles"), "reliable");
    const streamed = readStreamed(bytes);
    assert.equal(streamed.filter((record) => record.type === "Message").length, 1000);
    assert.ok(streamed.find((record) => record.type === "DataEnd").dataSectionCrc !== 0);
  });

test("both count the same messages in a recorded file", { skip: existsSync(recorded) ? false : `no ${recorded}` }, async () => {
  const { reader, messages } = await readIndexed(readFileSync(recorded));
  const counts = {};
  for (const [topic] of messages) counts[topic] = (counts[topic] ?? 0) + 1;
  for (const topic of opalInfo(recorded).topics) assert.equal(topic.messages, counts[topic.name] ?? 0, topic.name);
  assert.equal(Number(reader.statistics.messageCount), messages.length);
});

test("a file that is no recording is refused with its name", () => {
  const path = join(folder, "wrong.mcap");
  writeFileSync(path, "no recording");
  const run = spawnSync(process.env.OPAL_PROGRAM, ["info", path], { encoding: "utf8" });
  assert.equal(run.status, 3);
  assert.match(run.stderr, /wrong\.mcap: no log source recognizes this file/);
});
