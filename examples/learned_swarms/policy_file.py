"""A policy as an experiment file: the network of train.py as the controller `feed_forward_network`."""

import xml.etree.ElementTree as xml

import swarmanoid
from tasks import WHEELS


def add_field(parent, name, **attributes):
    """Adds the field "device.list.field[sectors=8 near]" as nested elements, its attributes at the innermost one."""
    path, _, brackets = name.partition("[")
    element = parent
    for tag in path.split("."):
        known = element.find(tag)
        element = xml.SubElement(element, tag) if known is None else known
    for word in brackets.rstrip("]").split():
        key, _, value = word.partition("=")
        element.set(key, value or "true")
    for key, value in attributes.items():
        element.set(key, str(value))


def numbers(tensors):
    """Numbers of some tensors, one after the other, with commas."""
    return ", ".join(repr(round(number, 6)) for tensor in tensors for number in tensor.flatten().tolist())


def experiment_with(task, network):
    """The text of the task's experiment in which the network controls the robots. @param network Linear, Tanh, Linear, Sigmoid"""
    root = xml.fromstring(swarmanoid.Simulation(task.experiment, overrides=task.overrides).record["text"])
    controllers = root.find("controllers")
    old = next(each for each in controllers if each.get("id") == task.controller)
    old.tag, old.attrib["library"] = "feed_forward_network", "feed_forward_network"
    parameters = old.find("parameters")
    parameters.clear()
    inputs, outputs = xml.SubElement(parameters, "inputs"), xml.SubElement(parameters, "outputs")
    for name in task.observations:
        add_field(inputs, name)
    for name, (low, high) in WHEELS.items():
        add_field(outputs, name, minimum=low, maximum=high)
    for name, value in task.constants.items():
        add_field(outputs, name, constant=value)
    layers = [network[0], network[2]]
    xml.SubElement(parameters, "hidden").text = str(layers[0].out_features)
    xml.SubElement(parameters, "weights").text = numbers(layer.weight for layer in layers)
    xml.SubElement(parameters, "biases").text = numbers(layer.bias for layer in layers)
    xml.indent(root)
    return xml.tostring(root, encoding="unicode") + "\n"


def mean_metric(experiment, task, overrides, seeds):
    """The metric at the end of a run, the mean over seeds."""
    found = [swarmanoid.Simulation(experiment, overrides=overrides, seed=seed).run()["metrics"][task.metric] for seed in seeds]
    return sum(found) / len(found)


def compare(task, learned, seeds=range(101, 121)):
    """The metric of a learned experiment and of the controller by hand: means over seeds that training has not used."""
    return mean_metric(learned, task, {}, seeds), mean_metric(task.experiment, task, task.overrides, seeds)
