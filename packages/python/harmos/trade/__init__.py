"""What accuracy costs: measures a scene or a study on a ladder of settings and finds the cheapest that keep a promise.

`harmos trade` runs it; see docs/guide/accuracy.md.
"""
