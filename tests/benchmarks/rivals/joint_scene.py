"""A joint as a scene of Harmos has it: mesh of an Exodus file, side sets, numbers of the laws."""
import xml.etree.ElementTree as xml

import numpy as np
from scipy.io import netcdf_file

# Nodes of the sides of a hexahedron, in Exodus' order, from 0.
SIDES = np.array([[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [0, 4, 7, 3], [0, 3, 2, 1], [4, 5, 6, 7]])


def entry(parent, name):
    return next(child for child in parent if child.get("name") == name)


class JointMesh:
    """Hexahedra of 8 nodes from a file of harmos mesh: `nodes`, `blocks` (node numbers from 0), `faces` of side sets."""

    def __init__(self, path):
        with netcdf_file(path, mmap=False) as file:
            variables = file.variables
            self.nodes = np.stack([variables["coord" + axis][:] for axis in "xyz"], axis=1)
            blocks = sorted((name for name in variables if name.startswith("connect")), key=lambda name: int(name[7:]))
            self.blocks = [variables[name][:].astype(int) - 1 for name in blocks]
            names = [row.tobytes().split(b"\0")[0].decode().strip() for row in variables["ss_names"][:]]
            elements = np.concatenate(self.blocks)
            self.faces = {}
            for number, name in enumerate(names, 1):
                element = variables[f"elem_ss{number}"][:] - 1
                side = variables[f"side_ss{number}"][:] - 1
                self.faces[name] = elements[element[:, None], SIDES[side]]

    def set_nodes(self, name):
        return np.unique(self.faces[name])

    def pairs(self, first, second):
        """Nodes of two side sets that lie on each other."""
        a, b = self.set_nodes(first), self.set_nodes(second)
        a, b = (nodes[np.lexsort(np.round(self.nodes[nodes], 6).T)] for nodes in (a, b))
        if len(a) != len(b) or np.abs(self.nodes[a] - self.nodes[b]).max() > 1e-6:
            raise SystemExit(f"the nodes of {first} and {second} do not match")
        return a, b

    def normal(self, name):
        """Of a plane side set, out of its part."""
        x = self.nodes[self.faces[name][0]]
        n = np.cross(x[2] - x[0], x[3] - x[1])
        return n / np.linalg.norm(n)

    def weights(self, name):
        """int N dS of the nodes of a side set, as a vector over all nodes [length^2]."""
        result = np.zeros(len(self.nodes))
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        for point in corners / np.sqrt(3.0):
            shape = 0.25 * (1 + corners[:, 0] * point[0]) * (1 + corners[:, 1] * point[1])
            slope = 0.25 * np.stack([corners[:, 0] * (1 + corners[:, 1] * point[1]),
                                     corners[:, 1] * (1 + corners[:, 0] * point[0])])
            x = self.nodes[self.faces[name]]
            tangents = np.einsum("ka,fac->kfc", slope, x)
            area = np.linalg.norm(np.cross(tangents[0], tangents[1]), axis=1)
            np.add.at(result, self.faces[name], area[:, None] * shape)
        return result


class JointScene:
    """Numbers of a scene whose parts have one material; preloads act at all load steps, loads grow from the second on."""

    def __init__(self, path, overrides=()):
        root = xml.parse(path).getroot()
        for override in overrides:
            place, value = override.split("=", 1)
            *lists, name = place.split("/")
            at = root
            for one in lists:
                at = entry(at, one)
            found = [child for child in at if child.get("name") == name]
            (found[0] if found else xml.SubElement(at, "Parameter", name=name)).set("value", value)
        values = {one.get("name"): one.get("value") for one in entry(root, "Values")}

        def number(parent, name, default=None):
            found = [child.get("value") for child in parent if child.get("name") == name]
            if not found:
                return default
            return float(values[found[0][1:]] if found[0].startswith("$") else found[0])

        material = entry(root, "Materials")[0]
        self.young, self.poisson = number(material, "Young's Modulus"), number(material, "Poisson's Ratio")
        self.increments = int(number(entry(entry(root, "Steps"), "load"), "Increments"))
        self.contacts, self.preloads, self.held, self.tractions = [], [], {}, {}
        for interface in entry(root, "Interfaces"):
            law = entry(interface, "Law")
            sides = tuple(entry(interface, side).get("value") for side in ("Side 1", "Side 2"))
            if entry(law, "Type").get("value") == "Coulomb Friction":
                self.contacts.append((sides, number(law, "Friction Coefficient")))
            else:
                self.preloads.append((sides, number(law, "Jump")))
        for boundary in entry(root, "Boundaries"):
            law = entry(boundary, "Law")
            where = entry(boundary, "Side Set").get("value")
            components = [number(law, axis) for axis in "XYZ"]
            if entry(law, "Type").get("value") == "Prescribed Displacement":
                self.held[where] = components
            else:
                self.tractions[where] = [component or 0.0 for component in components]
