# Godot's end of the connection to relay.py, which says what goes over it.
extends SceneTree

func shape_of(message):
	var count = message.get_16()
	var radius = message.get_float()
	var points = PoolVector2Array()
	for _i in range(count):
		points.push_back(Vector2(message.get_float(), message.get_float()))
	var shape
	if count == 1:
		shape = CircleShape2D.new()
		shape.radius = radius
	elif count == 2 and radius > 0: # along the y axis
		shape = CapsuleShape2D.new()
		shape.radius = radius
		shape.height = points[1].y
	elif count == 2:
		shape = SegmentShape2D.new()
		shape.a = points[0]
		shape.b = points[1]
	else:
		shape = ConvexPolygonShape2D.new()
		shape.points = points # as they stand; set_point_cloud would take the hull
	return shape

func transform_of(message):
	var position = Vector2(message.get_float(), message.get_float())
	var x_axis = Vector2(message.get_float(), message.get_float())
	return Transform2D(x_axis, Vector2(-x_axis.y, x_axis.x), position)

func _init():
	var relay = StreamPeerTCP.new()
	relay.connect_to_host("127.0.0.1", int(OS.get_environment("MANIFUZZ_PORT")))
	relay.set_no_delay(true)
	while true:
		var size = relay.get_data(4)
		if size[0] != OK: # the relay has ended
			break
		var message = StreamPeerBuffer.new()
		message.data_array = size[1]
		message.data_array = relay.get_data(message.get_32())[1]
		var a = shape_of(message)
		var from_a = transform_of(message)
		var b = shape_of(message)
		var contacts = a.collide_and_get_contacts(from_a, b, transform_of(message))
		var answer = StreamPeerBuffer.new()
		answer.put_32(contacts.size() if contacts else 0)
		for point in contacts if contacts else []:
			answer.put_float(point.x)
			answer.put_float(point.y)
		relay.put_data(answer.data_array)
	quit()
