import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.semanticweb.HermiT.Configuration;
import org.semanticweb.HermiT.Reasoner;
import org.semanticweb.owlapi.apibinding.OWLManager;
import org.semanticweb.owlapi.io.StringDocumentSource;
import org.semanticweb.owlapi.model.*;
import org.semanticweb.owlapi.reasoner.ReasonerInterruptedException;

/**
 * HermiT's opinion on many small ontologies in one process. Standard input: ontologies in functional syntax, each
 * followed by a line "%%%%". Standard output, for each: one line, "inconsistent", "failed: why", or "consistent" and what is
 * entailed of named individuals: C(a), p(a,b), d(a,literal), a=b, each word ending in a space. Run it without compiling:
 *
 *     java -cp HermiT.jar HermitJudge.java [beginnings of names] < ontologies
 *
 * With arguments, only the classes of individuals whose names begin with one of them and have no dot; an argument that
 * begins with http: only classes whose IRIs begin with it.
 */
public class HermitJudge {
    private static String name(OWLEntity entity) {
        String iri = entity.getIRI().toString();
        return iri.substring(Math.max(iri.lastIndexOf('#'), iri.lastIndexOf('/')) + 1);
    }

    /**
     * Whether a has to be in the class. Asked as satisfiability, since HermiT 1.3.8 contradicts itself when asked for class
     * assertions: on SubClassOf(C1 C0), DisjointUnion(C2 C0 not C1), Thing = {a0} it says that every Thing is a C2 and that
     * C2(a0) does not follow.
     */
    private static boolean follows(Reasoner reasoner, OWLDataFactory make, OWLNamedIndividual a, OWLClassExpression c) {
        return !reasoner.isSatisfiable(make.getOWLObjectIntersectionOf(make.getOWLObjectOneOf(a), make.getOWLObjectComplementOf(c)));
    }

    private static boolean isAsked(OWLNamedIndividual a, String[] beginnings) {
        if (beginnings.length == 0) return true;
        for (String beginning : beginnings)
            if (name(a).startsWith(beginning) && name(a).indexOf('.') < 0) return true;
        return false;
    }

    private static boolean isAsked(OWLClass c, String[] beginnings) {
        boolean isRestricted = false;
        for (String beginning : beginnings) {
            if (!beginning.startsWith("http")) continue;
            if (c.getIRI().toString().startsWith(beginning)) return true;
            isRestricted = true;
        }
        return !isRestricted;
    }

    private static String judge(String text, String[] beginnings) throws Exception {
        OWLOntologyManager manager = OWLManager.createOWLOntologyManager();
        OWLDataFactory make = manager.getOWLDataFactory();
        OWLOntology ontology = manager.loadOntologyFromOntologyDocument(new StringDocumentSource(text));
        Configuration configuration = new Configuration();
        configuration.individualTaskTimeout = Integer.getInteger("milliseconds", 10000);
        Reasoner reasoner = new Reasoner(configuration, ontology);
        try {
            if (!reasoner.isConsistent()) return "inconsistent";
            Set<String> found = new TreeSet<String>();
            Set<OWLNamedIndividual> everybody = ontology.getIndividualsInSignature();
            for (OWLNamedIndividual a : everybody) {
                if (!isAsked(a, beginnings)) continue;
                for (OWLClass c : ontology.getClassesInSignature())
                    if (!c.isOWLThing() && !c.isOWLNothing() && isAsked(c, beginnings) && follows(reasoner, make, a, c))
                        found.add(name(c) + "(" + name(a) + ")");
                if (beginnings.length > 0) continue;
                for (OWLNamedIndividual b : everybody) {
                    OWLClassExpression isB = make.getOWLObjectOneOf(b);
                    for (OWLObjectProperty p : ontology.getObjectPropertiesInSignature())
                        if (!p.isOWLTopObjectProperty() && !p.isOWLBottomObjectProperty() &&
                            follows(reasoner, make, a, make.getOWLObjectSomeValuesFrom(p, isB)))
                            found.add(name(p) + "(" + name(a) + "," + name(b) + ")");
                    if (a.compareTo(b) < 0 && follows(reasoner, make, a, isB)) found.add(name(a) + "=" + name(b));
                }
            }
            StringBuilder line = new StringBuilder("consistent ");
            for (String each : found) line.append(each).append(' ');
            return line.toString();
        } finally {
            reasoner.dispose();
        }
    }

    public static void main(String[] arguments) throws Exception {
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        StringBuilder text = new StringBuilder();
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            if (!line.equals("%%%%")) {
                text.append(line).append('\n');
                continue;
            }
            String answer;
            try {
                answer = judge(text.toString(), arguments);
            } catch (Throwable problem) {
                answer = "failed: " + String.valueOf(problem).replace('\n', ' ');
            }
            System.out.println(answer);
            System.out.flush();
            text.setLength(0);
        }
    }
}
