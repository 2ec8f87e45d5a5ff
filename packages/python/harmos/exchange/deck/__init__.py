"""Decks of Abaqus and CalculiX: read card by card, made into a mesh and a scene; what Harmos has not is listed."""
