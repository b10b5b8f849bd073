"""What the tests run on: the recorded hall that ships with Opal."""

from program_in_folder import DEMO, LOG, MAP, ROOT, InFolder

__all__ = ["DEMO", "LOG", "MAP", "ROOT", "InFolder", "scorers"]


def scorers(*types, **members):
    """A deployment document with these scorers."""
    return {"@context": "urn:opal:v1", "@type": "opal:Deployment", "scorers": [{"@type": name} for name in types],
            **members}
