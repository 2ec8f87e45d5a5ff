# A comment after a member is about the member: `double g;  // length` is read as `double g;  ///< length`.
/^ *[^ /].*[;,] *\/\/ /s|// |///< |
