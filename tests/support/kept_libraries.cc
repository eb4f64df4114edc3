// Loaded before the others where leaks are looked for: drivers and plug-ins stay, so that what they still
// hold when a program ends has their name, which support/leaks.supp needs.

extern "C" int dlclose(void* /*library*/)
{
    return 0;
}
