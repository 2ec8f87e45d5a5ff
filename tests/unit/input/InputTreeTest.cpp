#include <gtest/gtest.h>

#include "Sample.hpp"

namespace harmos::input {
namespace {

TEST(InputTree, KnowsFileAndLine) {
  const InputTree tree = InputTree::fromText(sampleText(), "dir/s.xml");
  EXPECT_EQ(tree.root.location, "dir/s.xml:1");
  EXPECT_EQ(tree.root.child("Joints")->child("seal")->location, "dir/s.xml:9");
}

TEST(InputTree, MalformedXmlHasItsLine) {
  EXPECT_EQ(
      messageOf([] { InputTree::fromText("<ParameterList name=\"Sample\">\n<Parameter>\n</ParameterList>", "s.xml"); }),
      "s.xml:3: not well-formed XML: mismatched tag, inside <Parameter> of s.xml:2.\n1 error; nothing was run.");
  EXPECT_EQ(messageOf([] { InputTree::fromText("<a b=c/>", "s.xml"); }),
            "s.xml:1: not well-formed XML: not well-formed (invalid token).\n1 error; nothing was run.");
  EXPECT_EQ(messageOf([] { InputTree::fromText("", "s.xml"); }),
            "s.xml:1: not well-formed XML: no element found.\n1 error; nothing was run.");
}

TEST(InputTree, WhatStandsElsewhereIsRefused) {
  EXPECT_EQ(messageOf([] {
              InputTree::fromText("<!DOCTYPE a [<!ENTITY load SYSTEM \"load.xml\">]>\n<a>\n&load;</a>", "s.xml");
            }),
            "s.xml:3: the external entity \"load.xml\" is not read.\n  Write its content into the file.\n"
            "1 error; nothing was run.");
  const std::string elsewhere =
      "s.xml:2: the declarations of the DOCTYPE that stand elsewhere are not read.\n"
      "  Remove the DOCTYPE and write what its entities stand for.\n1 error; nothing was run.";
  EXPECT_EQ(messageOf([] { InputTree::fromText("\n<!DOCTYPE a SYSTEM \"a.dtd\">\n<a b=\"1&x;0\"/>", "s.xml"); }),
            elsewhere);
  EXPECT_EQ(messageOf([] {
              InputTree::fromText("<!DOCTYPE a [<!ENTITY % p SYSTEM \"p.dtd\">\n%p;]>\n<a b=\"1&x;0\"/>", "s.xml");
            }),
            elsewhere);
  EXPECT_EQ(messageOf([] { InputTree::fromText("<a>\n&x;</a>", "s.xml"); }),
            "s.xml:2: not well-formed XML: undefined entity, inside <a> of s.xml:1.\n1 error; nothing was run.");
  const InputTree tree = InputTree::fromText("<!DOCTYPE a [<!ENTITY x \"5\">]>\n<a b=\"1&x;0\"/>", "s.xml");
  EXPECT_EQ(*tree.root.attribute("b"), "150");
}

TEST(InputTree, DeepNestingIsRefused) {
  std::string xml;
  for (int i = 0; i < 100000; ++i) xml += "<a>";
  EXPECT_EQ(messageOf([&] { InputTree::fromText(xml, "s.xml"); }),
            "s.xml:1: lists are nested more than 100 deep.\n1 error; nothing was run.");
}

TEST(InputTree, MissingFile) {
  EXPECT_EQ(messageOf([] { InputTree::fromFile("no_such.xml"); }),
            "no_such.xml: cannot be read (No such file or directory).");
  EXPECT_EQ(messageOf([] { InputTree::fromFile("/"); }), "/: cannot be read (empty or not a file).");
  EXPECT_EQ(messageOf([] { InputTree::fromFile("/dev/zero"); }),
            "/dev/zero:1: not well-formed XML: not well-formed (invalid token).\n1 error; nothing was run.");
}

}  // namespace
}  // namespace harmos::input
