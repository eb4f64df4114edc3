@tool
extends Node3D
## A tree of Ramure: each child is a level of detail, shown between two distances, with the wind's shader.

@export var distances: PackedFloat32Array = PackedFloat32Array()
@export var still_level: int = -1 # the billboard
@export var wind_direction: Vector2 = Vector2(1.0, 0.0)
@export var wind_strength: float = 0.5
@export var wind_shader: Shader

var made: Dictionary = {}


func _ready() -> void:
	for level in get_child_count():
		for mesh in get_child(level).find_children("*", "MeshInstance3D", true, false):
			mesh.visibility_range_begin = distances[level]
			if level + 1 < get_child_count():
				mesh.visibility_range_end = distances[level + 1]
			if level != still_level:
				for surface in mesh.mesh.get_surface_count():
					mesh.set_surface_override_material(surface, windy(mesh.mesh.surface_get_material(surface)))


func _process(_delta: float) -> void:
	for material in made.values():
		material.set_shader_parameter("wind_direction", wind_direction.normalized())
		material.set_shader_parameter("wind_strength", wind_strength)


func windy(source: BaseMaterial3D) -> ShaderMaterial:
	if not made.has(source):
		var material := ShaderMaterial.new()
		material.shader = wind_shader
		material.set_shader_parameter("albedo_texture", source.albedo_texture)
		material.set_shader_parameter("albedo", source.albedo_color)
		material.set_shader_parameter("roughness_factor", source.roughness)
		if source.normal_enabled:
			material.set_shader_parameter("normal_texture", source.normal_texture)
			material.set_shader_parameter("normal_scale", source.normal_scale)
		if source.transparency != BaseMaterial3D.TRANSPARENCY_DISABLED:
			material.set_shader_parameter("alpha_cut", 0.5)
		made[source] = material
	return made[source]
