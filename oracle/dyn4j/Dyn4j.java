import java.io.IOException;
import org.dyn4j.collision.manifold.ClippingManifoldSolver;
import org.dyn4j.collision.manifold.Manifold;
import org.dyn4j.collision.manifold.ManifoldPoint;
import org.dyn4j.collision.narrowphase.Gjk;
import org.dyn4j.collision.narrowphase.NarrowphaseDetector;
import org.dyn4j.collision.narrowphase.Penetration;
import org.dyn4j.collision.narrowphase.Sat;
import org.dyn4j.geometry.Capsule;
import org.dyn4j.geometry.Circle;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Polygon;
import org.dyn4j.geometry.Rotation;
import org.dyn4j.geometry.Segment;
import org.dyn4j.geometry.Transform;
import org.dyn4j.geometry.Vector2;

/** dyn4j's ClippingManifoldSolver after either detector: {@code java Dyn4j sat}, or {@code gjk}. */
public class Dyn4j {
  // second_point: Capsule.EDGE_FEATURE_SELECTION_CRITERIA is 0.98, the cosine of this angle.
  private static final String DECLARATION = """
      {"name": "dyn4j-%s", "version": "%s", "scalar": "float64", "frame": "world", "tie_bias": 0,
       "vertices_max": 8, "takes_radius": false, "vertices_min": 1, "takes_round": false,
       "second_point": 0.2003348423231196, "points": "clip", "normal": "b_to_a"}""";

  private static final String SNIPPET = """
      @language java
      @point getPoint() $p, getDepth() $d
      import org.dyn4j.collision.manifold.*; import org.dyn4j.collision.narrowphase.*; import org.dyn4j.geometry.*;
      public class Snippet {
        public static void main(String[] arguments) {
      @each @*.circle?     Circle @* = new Circle(@*.wide_radius@d);
      @each @*.circle?     @*.translate(@*.unit_vertices($X, $Y)@);
      @each @*.segment? @!*.rounded?     Segment @* = new Segment(@*.unit_vertices(new Vector2($Xd, $Yd))@);
      @each @*.segment? @*.rounded?     Vector2[] of@^ = {@*.unit_vertices(new Vector2($Xd, $Yd))@};
      @each @*.segment? @*.rounded?     Capsule @* = new Capsule(of@^[0].distance(of@^[1]) + 2 * @*.wide_radius@d, 2 * @*.wide_radius@d);
      @each @*.segment? @*.rounded?     @*.rotate(Rotation.of(of@^[0].to(of@^[1]))); @*.translate(of@^[0].sum(of@^[1]).multiply(0.5));
      @each @*.polygon?     Polygon @* = new Polygon(@*.unit_vertices(new Vector2($Xd, $Yd))@);
          Transform atA = new Transform(), atB = new Transform();
      @each @*.turned?     at@^.setRotation(Rotation.of(new Vector2(@*.rotation($X, $Y)@)));
      @each @*.moved?     at@^.setTranslation(@*.position($X, $Y)@);
          Penetration found = new Penetration(); Manifold manifold = new Manifold();
          if (new %s().@asked(detect)@(a, atA, b, atB, found))
            new ClippingManifoldSolver().getManifold(found, a, atA, b, atB, manifold);
          System.out.println(manifold.getPoints().size() + " points, " + manifold + ", " + found);
        }
      }
      """;

  private static Convex shapeOf(Protocol.Body body) {
    Vector2[] at = new Vector2[body.count()];
    for (int i = 0; i < at.length; ++i) {
      at[i] = new Vector2(body.vertices()[i][0], body.vertices()[i][1]).multiply(body.length());
    }
    double radius = body.radius();
    try {
      if (at.length > 2 && radius > 0) throw new Protocol.Unsupported("its polygons have no radius");
      if (at.length > 2) return new Polygon(at);
      if (at.length == 2 && radius == 0) return new Segment(at[0], at[1]);
      if (at.length == 2) return capsule(at[0], at[1], radius);
    } catch (IllegalArgumentException error) { // its own checks of shapes
      throw new Protocol.Unsupported(error.getMessage());
    }
    Circle circle = new Circle(radius);
    circle.translate(at[0]);
    return circle;
  }

  // dyn4j makes capsules along an axis.
  private static Capsule capsule(Vector2 start, Vector2 end, double radius) {
    Capsule capsule = new Capsule(start.distance(end) + 2 * radius, 2 * radius);
    capsule.rotate(Rotation.of(start.to(end)));
    capsule.translate(start.sum(end).multiply(0.5));
    return capsule;
  }

  private static Transform poseOf(Protocol.Body body) {
    Transform pose = new Transform();
    pose.setRotation(Rotation.of(new Vector2(body.rotation()[0], body.rotation()[1]))); // makes it unit
    pose.setTranslation(body.position()[0], body.position()[1]);
    return pose;
  }

  private static Protocol.Answer collide(NarrowphaseDetector detector, Protocol.Body a, Protocol.Body b) {
    Convex shapeA = shapeOf(a);
    Convex shapeB = shapeOf(b);
    Transform poseA = poseOf(a);
    Transform poseB = poseOf(b);
    Penetration penetration = new Penetration();
    Manifold manifold = new Manifold();
    Protocol.Answer answer = new Protocol.Answer();
    boolean touch = detector.detect(shapeA, poseA, shapeB, poseB, penetration)
        && new ClippingManifoldSolver().getManifold(
            penetration, shapeA, poseA, shapeB, poseB, manifold);
    if (!touch) return answer;
    for (ManifoldPoint point : manifold.getPoints()) {
      answer.add(point.getPoint().x, point.getPoint().y, point.getDepth());
    }
    answer.setNormal(manifold.getNormal().x, manifold.getNormal().y);
    return answer;
  }

  public static void main(String[] arguments) throws IOException {
    boolean isGjk = arguments.length == 1 && arguments[0].equals("gjk");
    if (!isGjk && !(arguments.length == 1 && arguments[0].equals("sat"))) {
      System.err.println("Dyn4j: 'sat' or 'gjk' is expected");
      System.exit(2);
    }
    NarrowphaseDetector detector = isGjk ? new Gjk() : new Sat();
    Protocol.serve(DECLARATION.formatted(isGjk ? "gjk" : "sat", Protocol.versionOf(Sat.class)),
        SNIPPET.formatted(isGjk ? "Gjk" : "Sat"), (a, b) -> collide(detector, a, b));
  }
}
