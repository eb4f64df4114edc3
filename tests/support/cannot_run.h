/// \file
/// What a suite does that needs something this machine lacks.
#pragma once

#include <QTest>

/// Leaves a suite (from initTestCase) or a test that cannot run here: skipped at a desk, failed in continuous
/// integration (CI in the environment). \p reason says what is missing.
#define RAMURE_CANNOT_RUN(reason)                                                                            \
    do {                                                                                                     \
        if (qEnvironmentVariableIsSet("CI"))                                                                 \
            QFAIL(reason);                                                                                   \
        QSKIP(reason);                                                                                       \
    } while (false)
