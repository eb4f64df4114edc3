/// \file
/// What the suites of mesh files share.
#pragma once

#include "core/io/mesh_file.h"
#include "tests/support/suite.h"
#include <QFile>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

namespace ramure::test {

inline QByteArray fileBytes(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("no such file");
}

inline void writeBytes(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

inline std::string_view view(const QByteArray& bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

/// Numbers of all sizes, with the hard ones among them.
inline float randomFloat(std::mt19937& random)
{
    switch (random() % 8) {
    case 0:
        return 0.0f;
    case 1:
        return -0.0f;
    case 2:
        return static_cast<float>(static_cast<int>(random() % 2001) - 1000);
    case 3: {
        const float f = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        return std::isfinite(f) ? f : 1.0f;
    }
    default:
        return static_cast<float>(static_cast<double>(random()) / 4294967296.0 * 8.0 - 4.0);
    }
}

/// Any mesh of at least one face: bad faces are not the business of files.
inline TriangleMesh randomMesh(std::mt19937& random, bool withAll)
{
    TriangleMesh mesh;
    const std::size_t vertices = 3 + random() % 60; // of one alone, readers would say that it is far away
    for (std::size_t i = 0; i < vertices; ++i) {
        mesh.positions.emplace_back(randomFloat(random), randomFloat(random), randomFloat(random));
        if (!withAll)
            continue;
        mesh.normals.emplace_back(randomFloat(random), randomFloat(random), randomFloat(random));
        if (mesh.normals.back() == glm::vec3(0.0f)) // which readers replace
            mesh.normals.back().y = 1.0f;
        mesh.branch.push_back(random() % 5 ? static_cast<Index>(random()) : noIndex);
        mesh.level.push_back(random() % 5 ? static_cast<Index>(random() % 100) : noIndex);
    }
    const std::size_t faces = 1 + random() % 80;
    for (std::size_t i = 0; i < faces; ++i)
        mesh.triangles.emplace_back(random() % vertices, random() % vertices, random() % vertices);
    return mesh;
}

inline bool sameBits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec3)) == 0);
}

inline TriangleMesh tetrahedron()
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

} // namespace ramure::test
