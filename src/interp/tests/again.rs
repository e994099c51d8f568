//! Files included more than once.

use super::textfiles::Folder;

/// A file that comes again is replayed from its tokens, loops, macros and what is skipped among them.
#[test]
fn a_file_included_again_means_the_same() {
    let folder = Folder::new("again");
    std::fs::write(
        folder.path("a.inc"),
        "#macro Twice(A) (2*(A)) #end
        #ifndef (Count) #declare Count = 0; #end
        #declare Count = Count + 1;
        #local I = 0; #while (I < 3) #if (I = 1) #debug \"one \" #else #debug str(Twice(I), 0, 0) #end
        #local I = I + 1; #end
        #switch (Count) #case (1) #debug \" first\" #break #range (2, 3) #debug \" later\" #break
        #else #debug \" last\" #end
        #for (J, 1, 2) #debug concat(\" \", str(J*Count, 0, 0)) #end
        #debug concat(\" \", str(Twice(Count), 0, 0), \"\\n\")
        mesh2 { vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,Count,0> } face_indices { 1, <0,1,2> } }
        #debug \"end\\n\"",
    )
    .unwrap();
    let outcome = folder.run("#for (K, 1, 4) #include \"a.inc\" #end #debug str(Twice(Count), 0, 0)");
    assert!(outcome.scene.is_ok(), "{:?}", outcome.scene.err());
    let expected = "0one 4 first 1 2 2\nend\n0one 4 later 2 4 4\nend\n0one 4 later 3 6 6\nend\n\
                    0one 4 last 4 8 8\nend\n8";
    assert_eq!(outcome.debug.trim_end(), expected);
    assert_eq!(outcome.scene.unwrap().objects.len(), 4);
}

/// What is wrong in a file that comes again is told where it stands.
#[test]
fn errors_in_a_file_included_again_have_their_place() {
    let folder = Folder::new("again-wrong");
    std::fs::write(folder.path("a.inc"), "#ifdef (Wrong)\n  sphere { 0, \"r\" }\n#end\n").unwrap();
    let outcome = folder.run("#include \"a.inc\" #include \"a.inc\" #declare Wrong = 1; #include \"a.inc\"");
    let error = outcome.scene.unwrap_err();
    assert_eq!(error.span.map(|s| (s.file.0, s.start)), Some((1, 29)), "{error:?}");
    std::fs::write(folder.path("b.inc"), "#if (1)\n").unwrap();
    let outcome = folder.run("#ifndef (X) #declare X = 1; #include \"b.inc\" #end");
    assert!(outcome.scene.is_err());
}
