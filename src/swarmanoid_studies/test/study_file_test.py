#!/usr/bin/python3
"""Study files are read strictly: errors are reported with file and line."""

import pathlib
import tempfile
import unittest

from swarmanoid_studies.mistakes import BadInput
from swarmanoid_studies.study_file import find_study, installed_studies, read_study

STUDY = """<study>
  <experiment>phototaxis</experiment>
  <overrides>
    <set path="framework.maxclock">300</set>
  </overrides>
  <genotype>
    <gene path="controllers.pc.parameters.speed" minimum="0" maximum="0.3"/>
  </genotype>
  <fitness seeds="1..3">
    <minimise metric="lamps.distance"/>
  </fitness>
  <optimiser>
    <cma_es><generations>4</generations></cma_es>
  </optimiser>
</study>
"""


class StudyFileTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "study.xml"

    def read(self, text):
        self.path.write_text(text)
        return read_study(str(self.path))

    def refused(self, message, old, new, line):
        self.assertIn(old, STUDY)
        with self.assertRaises(BadInput) as caught:
            self.read(STUDY.replace(old, new))
        self.assertEqual(str(caught.exception), f"{self.path}:{line}: {message}")

    def test_is_read(self):
        study = self.read(STUDY)
        self.assertEqual((study.name, study.experiment, study.seeds), ("study", "phototaxis", (1, 2, 3)))
        self.assertEqual(study.overrides, {"framework.maxclock": "300"})
        self.assertEqual(study.genes[0][:3], ("controllers.pc.parameters.speed", 0.0, 0.3))
        self.assertEqual(study.genes[0].value(0.5), 0.15)
        self.assertEqual(study.optimiser.parameters, {"generations": 4, "random_seed": 1, "population": 0, "sigma": 0.3})

    def test_a_vector_of_numbers_is_many_genes(self):
        study = self.read(STUDY.replace("</genotype>", '<genes path="controllers.nc.parameters.weights" count="3" minimum="-4" '
                                        'maximum="4"/></genotype>'))
        self.assertEqual((study.size(), [gene.count for gene in study.genes]), (4, [0, 3]))
        self.assertEqual(study.genes[1].names(), [f"controllers.nc.parameters.weights[{i}]" for i in range(3)])
        self.assertEqual(study.texts([0.5, 0.0, 0.1, 1.0]), {"controllers.pc.parameters.speed": "0.15",
                                                             "controllers.nc.parameters.weights": "-4.0, -3.2, 4.0"})

    def test_an_experiment_file_is_looked_for_beside_the_study(self):
        own = self.path.parent / "own.xml"
        own.write_text("<ahss-config/>")
        self.assertEqual(self.read(STUDY.replace(">phototaxis<", ">own.xml<")).experiment, str(own))

    def test_mistakes_are_reported_with_their_line(self):
        for message, old, new, line in (
                ("found the element 'genotipe', allowed: experiment, overrides, genotype, fitness, optimiser; did you mean "
                 "'genotype'?", "genotype>", "genotipe>", 6),
                ("found no <fitness>, allowed: one", '  <fitness seeds="1..3">\n    <minimise metric="lamps.distance"/>\n  </fitness>\n',
                 "", 1),
                ("found the range 0.4 to 0.3, allowed: minimum < maximum", 'minimum="0"', 'minimum="0.4"', 7),
                ("maximum: found 'nan', allowed: a number", 'maximum="0.3"', 'maximum="nan"', 7),
                ("found <gene> without maximum=\"...\", allowed: with it", ' maximum="0.3"', "", 7),
                ("found the attribute 'maximun', allowed: path, minimum, maximum; did you mean 'maximum'?", "maximum=", "maximun=", 7),
                ("found <genes> without count=\"...\", allowed: with it", "<gene ", "<genes ", 7),
                ("count: found '0', allowed: a whole number from 1 to 10000", "<gene ", '<genes count="0" ', 7),
                ("count: found 'all', allowed: a number", "<gene ", '<genes count="all" ', 7),
                ("found the attribute 'count', allowed: path, minimum, maximum", "<gene ", '<gene count="2" ', 7),
                ("found the element 'gens', allowed: gene, genes; did you mean 'genes'?", "<gene ", "<gens ", 7),
                ("seeds: found '3..1', allowed: seeds and ranges of seeds, such as 1..1000 or 1,2,10..20", "1..3", "3..1", 9),
                ("generations: found '0', allowed: a whole number from 1 to 1000000", ">4<", ">0<", 13),
                ("generations: found '1.5', allowed: a whole number from 1 to 1000000", ">4<", ">1.5<", 13),
                ("found <generations> without a value, allowed: a value", ">4<", "><", 13),
                ("found the element 'cma', allowed: cma_es, ga, nsga2; did you mean 'cma_es'?", "cma_es>", "cma>", 13),
                ("found 2 objectives, allowed with <cma_es>: one; <nsga2> takes several", "</fitness>",
                 '<maximise metric="x"/></fitness>', 13),
                ("found the text 'fast' in <genotype>, allowed: elements", "</genotype>", "fast</genotype>", 6),
                ("found the path 'framework.random_seed', allowed: seeds=\"...\" of <fitness>", "framework.maxclock",
                 "framework.random_seed", 4),
                ("found the path 'controllers.pc.parameters.speed' twice, allowed: once", "framework.maxclock",
                 "controllers.pc.parameters.speed", 4)):
            with self.subTest(message):
                self.refused(message, old, new, line)
        with self.assertRaisesRegex(BadInput, f"{self.path}:3: Opening and ending tag mismatch"):
            self.read("<study>\n<experiment>\n</study>")

    def test_entities_read_no_files(self):
        secret = self.path.parent / "secret"
        secret.write_text("phototaxis")
        with self.assertRaises(BadInput):
            self.read(f'<!DOCTYPE study [<!ENTITY e SYSTEM "{secret}">]>\n' + STUDY.replace(">phototaxis<", ">&e;<"))

    def test_installed_studies_have_names_and_are_read(self):
        self.assertIn("phototaxis", installed_studies())
        for name, path in installed_studies().items():
            self.assertEqual(find_study(name), path)
            read_study(path)
        with self.assertRaisesRegex(BadInput, "found the study 'fototaxis', allowed: .*; did you mean 'phototaxis'?"):
            find_study("fototaxis")


if __name__ == "__main__":
    unittest.main()
