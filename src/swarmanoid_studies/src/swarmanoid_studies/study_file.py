"""Study files: parameters to evolve, optimiser and objectives. XML, read strictly, as experiment files.

    <study>
      <experiment>phototaxis</experiment>
      <overrides> <set path="framework.maxclock">1610</set> </overrides>
      <genotype>
        <gene path="controllers.pc.parameters.speed" minimum="0" maximum="0.3"/>
        <genes path="controllers.nc.parameters.weights" count="48" minimum="-5" maximum="5"/>
      </genotype>
      <fitness seeds="1..5"> <minimise metric="lamps.distance_before_switch"/> </fitness>
      <optimiser> <cma_es> <generations>15</generations> <random_seed>1</random_seed> </cma_es> </optimiser>
    </study>
"""

import difflib
import math
import os
from typing import Dict, List, NamedTuple, NoReturn, Tuple

from lxml import etree

from .grid import SEED_PATH
from .input_file import NUMBER, read_file, shown
from .mistakes import BadInput
from .seeds import parse_seeds
from .study import Gene, Objective, OptimiserChoice, Study


class Bounds(NamedTuple):
    default: float
    least: float
    most: float
    is_whole: bool = True


MOST = 1_000_000
MOST_BYTES = 10_000_000   # of a file
MOST_GENES = 10_000   # per value
MOST_SEEDS = 100_000  # runs per genotype
COMMON = {"generations": Bounds(20, 1, MOST), "random_seed": Bounds(1, 0, 2 ** 63)}
OF_GA = {"population": Bounds(20, 4, 100_000), "crossover": Bounds(0.9, 0, 1, False), "mutation": Bounds(0, 0, 1, False)}
# parameters of each optimiser; 0: the optimiser computes the value
OPTIMISERS: Dict[str, Dict[str, Bounds]] = {
    "cma_es": {**COMMON, "population": Bounds(0, 0, 100_000), "sigma": Bounds(0.3, 1e-6, 10, False)},
    "ga": {**COMMON, **OF_GA},
    "nsga2": {**COMMON, **OF_GA},
}


def read_study(path: str) -> Study:
    """@raise BadInput with file and line"""
    content = read_file(path, MOST_BYTES)
    try:
        # no entities, which could read other files, and no network
        parser = etree.XMLParser(resolve_entities=False, no_network=True, remove_comments=True, remove_pis=True)
        root = etree.fromstring(content, parser)
    except etree.XMLSyntaxError as error:
        problem = " ".join((error.msg or "found nothing").split())
        raise BadInput(f"{path}:{error.lineno or 1}: {problem}, allowed: XML with <study>") from None
    return _Reader(path).study(root)


def installed_studies() -> Dict[str, str]:
    """Files by name. The module lies in PREFIX/lib/python3/dist-packages/swarmanoid_studies."""
    prefix = os.path.abspath(os.path.join(os.path.dirname(__file__), *[os.pardir] * 4))
    folder = os.path.join(prefix, "share", "swarmanoid_studies", "studies")
    names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    return {os.path.splitext(name)[0]: os.path.join(folder, name) for name in names if name.endswith(".xml")}


def find_study(file_or_name: str) -> str:
    """@raise BadInput"""
    installed = installed_studies()
    if os.path.exists(file_or_name):
        return file_or_name
    if file_or_name in installed:
        return installed[file_or_name]
    raise BadInput(_unknown("the study", file_or_name, list(installed)))


def _unknown(what: str, name: str, known: List[str]) -> str:
    near = difflib.get_close_matches(name, known, 1)
    return f"found {what} '{shown(name)}', allowed: {', '.join(known)}" + (f"; did you mean '{near[0]}'?" if near else "")


class _Reader:
    def __init__(self, path: str) -> None:
        self._path = path

    def study(self, root: etree._Element) -> Study:
        if root.tag != "study":
            self._refuse(root, f"found <{shown(root.tag)}>, allowed: <study>")
        self._attributes(root)
        parts = self._children(root, {"experiment": True, "overrides": False, "genotype": True, "fitness": True, "optimiser": True})
        genes = self._genes(parts["genotype"])
        overrides = self._overrides(parts["overrides"], genes) if "overrides" in parts else {}
        seeds, objectives = self._fitness(parts["fitness"])
        name = os.path.splitext(os.path.basename(self._path))[0]
        return Study(name, self._experiment(parts["experiment"]), overrides, genes, seeds, objectives,
                     self._optimiser(parts["optimiser"], len(objectives)))

    def _experiment(self, element: etree._Element) -> str:
        self._attributes(element)
        text = self._text(element)
        beside = os.path.join(os.path.dirname(os.path.abspath(self._path)), text)
        return beside if os.path.exists(beside) else text

    def _overrides(self, element: etree._Element, genes: Tuple[Gene, ...]) -> Dict[str, str]:
        self._attributes(element)
        found: Dict[str, str] = {}
        for child in self._all(element, ("set",)):
            path = self._attributes(child, "path")["path"]
            if path == SEED_PATH:
                self._refuse(child, f"found the path '{path}', allowed: seeds=\"...\" of <fitness>")
            if path in found or any(gene.path == path for gene in genes):
                self._refuse(child, f"found the path '{path}' twice, allowed: once")
            found[path] = self._text(child)
        return found

    def _genes(self, element: etree._Element) -> Tuple[Gene, ...]:
        self._attributes(element)
        genes: List[Gene] = []
        for child in self._all(element, ("gene", "genes")):
            is_vector = child.tag == "genes"
            values = self._attributes(child, "path", *(["count"] if is_vector else []), "minimum", "maximum")
            ends = (self._number(child, name, values[name]) for name in ("minimum", "maximum"))
            count = self._within(child, "count", values["count"], Bounds(0, 1, MOST_GENES)) if is_vector else 0
            gene = Gene(values["path"], *ends, self._where(child), int(count))
            self._text(child, is_empty=True)
            if gene.minimum >= gene.maximum:
                self._refuse(child, f"found the range {values['minimum']} to {values['maximum']}, allowed: minimum < maximum")
            if math.isinf(gene.maximum - gene.minimum):
                self._refuse(child, f"found the range {values['minimum']} to {values['maximum']}, allowed: one whose width is finite")
            if any(other.path == gene.path for other in genes):
                self._refuse(child, f"found the path '{gene.path}' twice, allowed: once")
            genes.append(gene)
        if not genes:
            self._refuse(element, "found no <gene>, allowed: at least one, or <genes>")
        return tuple(genes)

    def _fitness(self, element: etree._Element) -> Tuple[Tuple[int, ...], Tuple[Objective, ...]]:
        seeds = parse_seeds(self._attributes(element, "seeds")["seeds"], f"{self._where(element)}: seeds", MOST_SEEDS)
        objectives: List[Objective] = []
        for child in self._all(element, ("minimise", "maximise")):
            metric = self._attributes(child, "metric")["metric"]
            objectives.append(Objective(metric, child.tag == "minimise", self._where(child)))
            self._text(child, is_empty=True)
        if not objectives:
            self._refuse(element, "found no objective, allowed: <minimise metric=\"...\"/> and <maximise metric=\"...\"/>")
        return tuple(seeds), tuple(objectives)

    def _optimiser(self, element: etree._Element, objectives: int) -> OptimiserChoice:
        self._attributes(element)
        children = self._all(element, tuple(OPTIMISERS))
        if len(children) != 1:
            self._refuse(element, f"found {len(children)} optimisers, allowed: one of {', '.join(OPTIMISERS)}")
        kind = children[0].tag
        self._attributes(children[0])
        if objectives > 1 and kind != "nsga2":
            self._refuse(children[0], f"found {objectives} objectives, allowed with <{kind}>: one; <nsga2> takes several")
        bounds = OPTIMISERS[kind]
        parameters = {name: bound.default for name, bound in bounds.items()}
        for name, child in self._children(children[0], dict.fromkeys(bounds, False)).items():
            self._attributes(child)
            parameters[name] = self._bounded(child, bounds[name])
        if kind == "nsga2" and parameters["population"] % 4:
            self._refuse(children[0], f"population: found {parameters['population']}, allowed: a multiple of 4")
        return OptimiserChoice(kind, parameters)

    def _bounded(self, element: etree._Element, bounds: Bounds) -> float:
        return self._within(element, element.tag, self._text(element), bounds)

    def _within(self, element: etree._Element, name: str, text: str, bounds: Bounds) -> float:
        value = self._number(element, name, text)
        is_digits = text.isdecimal() and len(text) < 20
        if bounds.is_whole and is_digits:
            value = int(text)   # exact, with all digits
        if not bounds.least <= value <= bounds.most or bounds.is_whole and not is_digits:
            kind = "a whole number" if bounds.is_whole else "a number"
            self._refuse(element, f"{name}: found '{shown(text)}', allowed: {kind} from {bounds.least} to {bounds.most}")
        return value

    def _number(self, element: etree._Element, name: str, text: str) -> float:
        value = float(text) if NUMBER.fullmatch(text) else math.nan
        if not math.isfinite(value):
            self._refuse(element, f"{name}: found '{shown(text)}', allowed: a number")
        return value

    def _children(self, element: etree._Element, names: Dict[str, bool]) -> Dict[str, etree._Element]:
        """Children by tag, each at most once. @param names whether each is required"""
        found: Dict[str, etree._Element] = {}
        for child in self._all(element, tuple(names)):
            if child.tag in found:
                self._refuse(child, f"found <{child.tag}> twice, allowed: once")
            found[child.tag] = child
        missing = [name for name, is_needed in names.items() if is_needed and name not in found]
        if missing:
            self._refuse(element, f"found no <{missing[0]}>, allowed: one")
        return found

    def _all(self, element: etree._Element, names: Tuple[str, ...]) -> List[etree._Element]:
        for text in (element.text, *(child.tail for child in element)):
            if text and text.strip():
                self._refuse(element, f"found the text '{shown(text.strip())}' in <{element.tag}>, allowed: elements")
        for child in element:
            if child.tag not in names:
                self._refuse(child, _unknown("the element", str(child.tag), list(names)))
        return list(element)

    def _attributes(self, element: etree._Element, *names: str) -> Dict[str, str]:
        for name in element.attrib:
            if name not in names:
                self._refuse(element, _unknown("the attribute", str(name), list(names)) if names else
                             f"found the attribute '{shown(name)}', allowed: none in <{element.tag}>")
        for name in names:
            if name not in element.attrib:
                self._refuse(element, f"found <{element.tag}> without {name}=\"...\", allowed: with it")
        return {name: element.attrib[name].strip() for name in names}

    def _text(self, element: etree._Element, is_empty: bool = False) -> str:
        text = (element.text or "").strip()
        if len(element) or bool(text) == is_empty:
            self._refuse(element, f"found <{element.tag}> {'that is not empty' if is_empty else 'without a value'}, allowed: "
                                  f"{'nothing in it' if is_empty else 'a value'}")
        return text

    def _where(self, element: etree._Element) -> str:
        return f"{self._path}:{element.sourceline}"

    def _refuse(self, element: etree._Element, message: str) -> NoReturn:
        raise BadInput(f"{self._where(element)}: {message}")
