// Exists so that the widget suites can share one precompiled header.
