#!/usr/bin/python3
"""Names what is public in a Python package and not documented: docstrings.py FOLDER

Modules, classes, functions and methods need a docstring, constants of a module one below them; attributes are named in
the docstring of their class.
"""
import ast
import collections.abc
import pathlib
import re
import sys

Definition = (ast.ClassDef, ast.FunctionDef)


def is_public(name: str) -> bool:
    return not name.startswith("_") or name in ("__init__", "__call__")


def assigned(node: ast.Assign | ast.AnnAssign) -> list[str]:
    """Public names that a statement gives a value to."""
    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
    return [each.id for target in targets for each in ast.walk(target)
            if isinstance(each, ast.Name) and is_public(each.id)]


def attributes(node: ast.ClassDef) -> list[str]:
    """Public attributes that the body of a class declares or its methods set."""
    declared = [name for each in node.body if isinstance(each, (ast.Assign, ast.AnnAssign)) for name in assigned(each)]
    return declared + [each.attr for each in ast.walk(node)
                       if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Store) and is_public(each.attr)]


def undocumented(node: ast.Module | ast.ClassDef | ast.FunctionDef, name: str) -> collections.abc.Iterator[str]:
    text = ast.get_docstring(node)
    if text is None:
        yield name
    if isinstance(node, ast.ClassDef):
        known = re.findall(r"^    (\w+): ", text or "", re.MULTILINE)
        yield from (f"{name}.{each}" for each in dict.fromkeys(attributes(node)) if each not in known)
    if isinstance(node, ast.Module):
        for each, below in zip(node.body, [*node.body[1:], ast.Pass()]):
            if isinstance(each, (ast.Assign, ast.AnnAssign)) and not (
                    isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant)):
                yield from (f"{name}.{constant}" for constant in assigned(each))
    if not isinstance(node, ast.FunctionDef):
        for child in node.body:
            if isinstance(child, Definition) and is_public(child.name):
                yield from undocumented(child, f"{name}.{child.name}")


folder = pathlib.Path(sys.argv[1])
sources = sorted(folder.rglob("*.py"))
missing = [name for path in sources
           for name in undocumented(ast.parse(path.read_text()), str(path.relative_to(folder).with_suffix("")))]
print(f"{len(sources)} modules; without docstring: {', '.join(missing) or 'nothing'}")
sys.exit(bool(missing) or not sources)
