"""What `opal ros2` sends, as tshark's dissector of RTPS sees it on the loopback: names, types and qualities of service."""

import shutil
import subprocess
import time
import unittest
import xml.etree.ElementTree

from bench import PATIENCE_S, Bench

CYCLONE = "0x0110"  # the vendor, as RTPS numbers them
DATA = "0x15"
PUBLICATIONS, SUBSCRIPTIONS = "0x000003c2", "0x000004c2"  # built-in writers of discovery
QUALITIES = {"0x00000001": "best effort", "0x00000002": "reliable"}
DURABILITIES = {"0x00000000": "volatile", "0x00000001": "transient local"}
PLAIN_CDR = "0x0001"


def capture_tool():
    """None if packets of the loopback can be captured here, else why not."""
    if shutil.which("tshark") is None:
        return "no tshark: apt-get install tshark"
    tried = subprocess.run(["tshark", "-i", "lo", "-a", "duration:1", "-q"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           text=True, check=False)
    return None if tried.returncode == 0 else "tshark may not capture here: " + tried.stdout.strip().splitlines()[-1]


def first(submessage, name):
    found = submessage.find(f".//field[@name='{name}']")
    return None if found is None else found.get("show")


class OnTheWire(Bench):
    def setUp(self):
        why_not = capture_tool()
        if why_not:
            self.skipTest(why_not)
        super().setUp()

    def test_names_types_and_qualities_are_those_of_ros_2(self):
        submessages = self.captured(lambda: self.drive(10, "tf", "best_effort"))
        published = self.offers(submessages, PUBLICATIONS, unless_stated="reliable")
        subscribed = self.offers(submessages, SUBSCRIPTIONS, unless_stated="best effort")
        latched, passing = "reliable, transient local", "reliable, volatile"
        self.assertEqual(published, {
            "rt/tf": ("tf2_msgs::msg::dds_::TFMessage_", passing),
            "rt/amcl_pose": ("geometry_msgs::msg::dds_::PoseWithCovarianceStamped_", latched),
            "rt/opal/places": ("geometry_msgs::msg::dds_::PoseArray_", latched),
            "rt/opal/place_markers": ("visualization_msgs::msg::dds_::MarkerArray_", latched),
            "rt/opal/map": ("nav_msgs::msg::dds_::OccupancyGrid_", latched),
            "rt/opal/walls": ("visualization_msgs::msg::dds_::MarkerArray_", latched),
            "rt/diagnostics": ("diagnostic_msgs::msg::dds_::DiagnosticArray_", passing)})
        self.assertEqual(subscribed["rt/scan"], ("sensor_msgs::msg::dds_::LaserScan_", "best effort, volatile"))
        self.assertEqual(subscribed["rt/tf_static"], ("tf2_msgs::msg::dds_::TFMessage_", latched))
        for topic, (kind, quality) in subscribed.items():
            self.assertTrue(topic.startswith("rt/") and "::msg::dds_::" in kind and quality, topic)

    def test_messages_are_sent_as_plain_cdr(self):
        submessages = self.captured(lambda: self.drive(10, "tf", "reliable"))
        sent = {}
        for submessage in submessages:
            topic, kind = first(submessage, "rtps.param.topicName"), first(submessage, "rtps.param.serialize.encap_kind")
            if first(submessage, "rtps.sm.wrEntityId") not in (PUBLICATIONS, SUBSCRIPTIONS) and topic and kind:
                sent.setdefault(topic, set()).add(kind)
        for topic in ("rt/tf", "rt/amcl_pose", "rt/diagnostics"):
            self.assertEqual(sent.get(topic), {PLAIN_CDR}, sent)

    def captured(self, act):
        """The submessages with data that Cyclone DDS sent on this domain meanwhile."""
        file = self.folder / "wire.pcapng"
        capture = subprocess.Popen(["tshark", "-i", "lo", "-f", "udp", "-q", "-w", file], stderr=subprocess.PIPE, text=True)
        self.addCleanup(capture.stderr.close)
        self.addCleanup(capture.kill)
        self.wait_until(lambda: file.exists() and file.stat().st_size > 0)
        time.sleep(0.5)  # the file begins before the packets do
        act()
        capture.terminate()
        capture.wait(timeout=PATIENCE_S)
        chosen = f"rtps.vendorId == {CYCLONE} && rtps.domain_id == {self.domain} && rtps.sm.id == {DATA}"
        dissected = subprocess.run(["tshark", "-r", file, "-Y", chosen, "-T", "pdml"], stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, timeout=PATIENCE_S, check=True)
        tree = xml.etree.ElementTree.fromstring(dissected.stdout)
        found = [field for proto in tree.iter("proto") if proto.get("name") == "rtps" for field in proto
                 if field.get("name") == "rtps.sm.id" and field.get("show") == DATA]
        self.assertTrue(found, "nothing was captured")
        return found

    def wait_until(self, is_so):
        end = time.monotonic() + PATIENCE_S
        while not is_so() and time.monotonic() < end:
            time.sleep(0.05)

    def offers(self, submessages, writer, unless_stated):
        """Type and quality by topic, of what this built-in writer has announced. Default values are not sent."""
        offers = {}
        for submessage in submessages:
            topic = first(submessage, "rtps.param.topicName")
            if first(submessage, "rtps.sm.wrEntityId") != writer or topic is None:
                continue
            stated = first(submessage, "rtps.reliability_kind")
            quality = unless_stated if stated is None else QUALITIES[stated]
            durability = DURABILITIES[first(submessage, "rtps.durability") or "0x00000000"]
            offers[topic] = (first(submessage, "rtps.param.typeName"), f"{quality}, {durability}")
        return offers


if __name__ == "__main__":
    unittest.main()
