#include "tests/support/cannot_run.h"
#include "tests/support/suite.h"
#include "widgets/view/render/passes/gl_setup.h"
#include "widgets/view/render/stream/buffer_pool.h"
#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>
#include <memory>

namespace tst_buffer_pool {

using namespace ramure;

class TestBufferPool : public QObject
{
    Q_OBJECT
public:
    static void initMain() { prepareOpenGl(); }

    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    Gl* m_gl = nullptr;
    std::unique_ptr<BufferPool> m_pool;

    GpuBuffer filled(std::size_t bytes)
    {
        GpuBuffer buffer = m_pool->take(bytes);
        m_pool->allocate(buffer, bytes);
        return buffer;
    }

private slots:
    void initTestCase()
    {
        const OpenGlProbe probe = probeOpenGl();
        if (!probe.available)
            RAMURE_CANNOT_RUN(qPrintable(probe.reason));
        QVERIFY(m_context.create());
        m_surface.setFormat(m_context.format());
        m_surface.create();
        QVERIFY(m_context.makeCurrent(&m_surface));
        m_gl = QOpenGLVersionFunctionsFactory::get<Gl>(&m_context);
        QVERIFY(m_gl && m_gl->initializeOpenGLFunctions());
    }
    void init()
    {
        test::failOnAnyWarning();
        m_pool = std::make_unique<BufferPool>(*m_gl);
    }
    void cleanup()
    {
        m_pool.reset();
        QCOMPARE(m_gl->glGetError(), GLenum(GL_NO_ERROR));
    }

    void namesWithoutMemoryAreNotKept()
    {
        const GpuBuffer buffer = m_pool->take(1000);
        QVERIFY(buffer.name != 0);
        QCOMPARE(buffer.capacity, std::size_t(0));
        m_pool->giveBack(buffer);
        m_pool->giveBack({});
        QCOMPARE(m_pool->idle(), std::size_t(0));
    }
    void emptyBlocksNeedNoMemory()
    {
        GpuBuffer buffer = m_pool->take(0);
        QVERIFY(!m_pool->allocate(buffer, 0));
        m_pool->giveBack(buffer);
    }
    void nearlyTheSameSizeIsUsedAgain()
    {
        GpuBuffer first = m_pool->take(10'000);
        QVERIFY(m_pool->allocate(first, 10'000));
        QVERIFY(first.capacity >= 10'000);
        m_pool->giveBack(first);
        for (const std::size_t bytes : {9'000u, 10'000u, 10'500u, 6'000u}) {
            GpuBuffer again = m_pool->take(bytes);
            QCOMPARE(again.name, first.name);
            QVERIFY(!m_pool->allocate(again, bytes));
            m_pool->giveBack(again);
        }
    }
    void tooSmallAndWastefulBuffersStayIdle()
    {
        const GpuBuffer first = filled(10'000);
        m_pool->giveBack(first);
        for (const std::size_t bytes : {100u, 5'000u, 12'000u})
            QVERIFY(m_pool->take(bytes).name != first.name);
        QCOMPARE(m_pool->idle(), first.capacity);
    }
    void theSmallestThatFitsIsTaken()
    {
        const GpuBuffer large = filled(15'000);
        const GpuBuffer small = filled(10'000);
        m_pool->giveBack(large);
        m_pool->giveBack(small);
        QCOMPARE(m_pool->take(9'000).name, small.name);
        QCOMPARE(m_pool->take(9'000).name, large.name);
    }
    void idleMemoryIsBounded()
    {
        constexpr std::size_t size = BufferPool::idleBytes / 4;
        std::vector<GpuBuffer> all;
        for (int i = 0; i < 6; ++i)
            all.push_back(filled(size));
        for (const GpuBuffer& buffer : all) {
            m_pool->giveBack(buffer);
            QVERIFY(m_pool->idle() <= BufferPool::idleBytes);
        }
        QVERIFY(m_pool->idle() > BufferPool::idleBytes / 2);
        // The longest idle ones went first.
        QVERIFY(!m_gl->glIsBuffer(all.front().name));
        QVERIFY(m_gl->glIsBuffer(all.back().name));
    }
};

RAMURE_SUITE(TestBufferPool)

} // namespace tst_buffer_pool

#include "tst_buffer_pool.moc"
