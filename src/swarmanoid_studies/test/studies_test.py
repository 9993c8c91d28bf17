#!/usr/bin/python3
"""The installed studies, each with a reduced size: two generations of few genotypes, with two seeds."""

import json
import re
import subprocess
import unittest

from commands import CommandsTest
from swarmanoid_studies.study_file import find_study, installed_studies, read_study

NAMES = ["neural_aggregation", "neural_phototaxis", "object_retrieval", "phototaxis"]
POPULATION = 5


def in_small(text):
    for element, value in (("generations", 2), ("population", POPULATION)):
        text, count = re.subn(f"<{element}>[0-9]+</{element}>", f"<{element}>{value}</{element}>", text)
        assert count == 1, element
    text, count = re.subn('seeds="[^"]*"', 'seeds="1..2"', text)
    assert count == 1
    return text


class StudiesTest(CommandsTest):
    def test_all_are_here(self):
        self.assertEqual(sorted(installed_studies()), NAMES)

    def test_each_finds_something_and_its_best_is_an_experiment(self):
        for name in NAMES:
            with self.subTest(name):
                with open(find_study(name)) as file:
                    (self.folder / f"{name}.xml").write_text(in_small(file.read()))
                summary = self.call("evolve", f"{name}.xml", "--out", f"{name}_out", "--quiet", "--jobs", 2)
                self.assertEqual((summary["generations"], summary["population"]), (2, POPULATION))
                self.assertEqual(summary["runs_with_failed_controllers"], 0)
                best, = summary["best"]
                study = read_study(find_study(name))
                self.assert_vectors_are_whole(study, best["genes"])
                metric, = best["values"]
                self.assertAlmostEqual(sum(self.run_metric(best["file"], seed, metric) for seed in (1, 2)) / 2,
                                       best["values"][metric], delta=1e-12)

    def assert_vectors_are_whole(self, study, genes):
        for gene in study.genes:
            values = genes[gene.path] if gene.count else [genes[gene.path]]
            self.assertEqual(len(values), gene.size())
            self.assertTrue(all(gene.minimum <= value <= gene.maximum for value in values))

    def run_metric(self, file, seed, metric):
        done = subprocess.run(["swarmanoid", "run", file, "--seed", str(seed), "--quiet"], cwd=self.folder, check=True,
                              stdout=subprocess.PIPE, text=True)
        return json.loads(done.stdout)["metrics"][metric]


if __name__ == "__main__":
    unittest.main()
