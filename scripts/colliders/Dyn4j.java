// dyn4j's Sat and ClippingManifoldSolver for manifuzz:
// `manifuzz fuzz --subject-command "java -cp dyn4j-6.0.0.jar Dyn4j.java"`.

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.util.Arrays;
import java.util.StringJoiner;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dyn4j.collision.manifold.ClippingManifoldSolver;
import org.dyn4j.collision.manifold.Manifold;
import org.dyn4j.collision.manifold.ManifoldPoint;
import org.dyn4j.collision.narrowphase.Penetration;
import org.dyn4j.collision.narrowphase.Sat;
import org.dyn4j.geometry.Polygon;
import org.dyn4j.geometry.Rotation;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;

public class Dyn4j {
  private static final String DECLARATION = """
      {"declaration": {"name": "dyn4j", "version": "6.0.0", "scalar": "float64", "frame": "world", \
      "tie_bias": 0, "vertices_max": 8, "takes_radius": false, "points": "clip", "normal": "b_to_a"}}""";

  // A body as manifuzz writes it: every key, in this order. The polygons have no radius.
  private static final Pattern BODY = Pattern.compile(
      "\"vertices\": \\[(.*?)\\], \"radius\": .*?, \"position\": (.*?), \"rotation\": (.*?)}");

  // Every number of a case is a float; its line has the shortest decimal of it.
  private static double[] floats(String text) {
    return Arrays.stream(text.split("[\\[\\],]+"))
        .filter(number -> !number.isEmpty()).mapToDouble(Float::parseFloat).toArray();
  }

  // The stored (cos, sin) is a unit vector to 32 bits only, and dyn4j wants one to 64: what it
  // lacks goes into the vertices, (R / length) (length v) + p is the same polygon.
  private record Body(Polygon polygon, Transform transform) {
    static Body read(Matcher matcher) {
      if (!matcher.find()) throw new IllegalArgumentException("a body is missing");
      double[] numbers = floats(matcher.group(1));
      double[] position = floats(matcher.group(2));
      double[] rotation = floats(matcher.group(3));
      double length = Math.sqrt(rotation[0] * rotation[0] + rotation[1] * rotation[1]);
      Vector2[] vertices = new Vector2[numbers.length / 2];
      for (int i = 0; i < vertices.length; ++i) {
        vertices[i] = new Vector2(length * numbers[2 * i], length * numbers[2 * i + 1]);
      }
      Transform transform = new Transform();
      transform.setRotation(Rotation.of(new Vector2(rotation[0], rotation[1]))); // makes it unit
      transform.setTranslation(position[0], position[1]);
      return new Body(new Polygon(vertices), transform);
    }
  }

  private static String collide(Body a, Body b) {
    Penetration penetration = new Penetration();
    Manifold manifold = new Manifold();
    boolean touch = new Sat().detect(a.polygon, a.transform, b.polygon, b.transform, penetration)
        && new ClippingManifoldSolver().getManifold(
            penetration, a.polygon, a.transform, b.polygon, b.transform, manifold);
    if (!touch) return "{\"points\": []}";
    StringJoiner points = new StringJoiner(", ");
    for (ManifoldPoint point : manifold.getPoints()) {
      Vector2 at = point.getPoint();
      points.add("{\"position\": [" + at.x + ", " + at.y + "], \"depth\": " + point.getDepth() + "}");
    }
    Vector2 normal = manifold.getNormal();
    return "{\"points\": [" + points + "], \"normal\": [" + normal.x + ", " + normal.y + "]}";
  }

  private static String answer(String line) {
    try {
      Matcher bodies = BODY.matcher(line);
      return collide(Body.read(bodies), Body.read(bodies));
    } catch (IllegalArgumentException error) { // of dyn4j's own checks of polygons
      return "{\"unsupported\": \"" + error.getMessage().replaceAll("[\"\\\\\\p{Cntrl}]", " ") + "\"}";
    }
  }

  public static void main(String[] arguments) throws IOException {
    System.out.println(DECLARATION);
    BufferedReader lines = new BufferedReader(new InputStreamReader(System.in));
    for (String line; (line = lines.readLine()) != null; ) {
      if (!line.isBlank()) System.out.println(answer(line)); // flushes each line
    }
  }
}
